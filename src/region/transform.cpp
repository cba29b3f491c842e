#include "minksum/transform.hpp"

#include <optional>

#include "machine/cancellation.hpp"
#include "region/map_points.hpp"
#include "region/turned.hpp"

namespace minksum {
namespace {

/// Returns by how many right angles a map turns, or nothing if it does anything else.
std::optional<int> quarters_of(const Affine& map) {
  if (map.dx.sign() != 0 || map.dy.sign() != 0) return std::nullopt;
  if (map.xx != map.yy || map.yx != -map.xy) return std::nullopt;
  if (map.yx.sign() == 0 && map.xx == 1) return 0;
  if (map.xx.sign() == 0 && map.yx == 1) return 1;
  if (map.yx.sign() == 0 && map.xx == -1) return 2;
  if (map.xx.sign() == 0 && map.yx == -1) return 3;
  return std::nullopt;
}

/// Returns the map, which counts its work.
auto counting(const Affine& map, Cancellation& cancellation) {
  return [&](const Point& point) {
    const Point image = map(point);
    cancellation.check(4 * work_of(image));
    return image;
  };
}

}  // namespace

Affine Affine::translation(const Rational& dx, const Rational& dy) { return {1, 0, dx, 0, 1, dy}; }

Affine Affine::scaling(const Rational& factor) { return {factor, 0, 0, 0, factor, 0}; }

Affine Affine::rotation(const Rational& half) {
  const Rational square = half * half;
  const Rational whole = Rational(1) + square;
  const Rational cosine = (Rational(1) - square) / whole;
  const Rational sine = Rational(2) * half / whole;
  return {cosine, -sine, 0, sine, cosine, 0};
}

Affine Affine::quarter_turns(int turns) {
  constexpr int kCosine[] = {1, 0, -1, 0};
  const int quarter = ((turns % 4) + 4) % 4;
  const int cosine = kCosine[quarter];
  const int sine = kCosine[(quarter + 3) % 4];
  return {cosine, -sine, 0, sine, cosine, 0};
}

Affine Affine::after(const Affine& first) const {
  Affine map;
  map.xx = xx * first.xx + xy * first.yx;
  map.xy = xx * first.xy + xy * first.yy;
  map.dx = xx * first.dx + xy * first.dy + dx;
  map.yx = yx * first.xx + yy * first.yx;
  map.yy = yx * first.xy + yy * first.yy;
  map.dy = yx * first.dx + yy * first.dy + dy;
  return map;
}

Point Affine::operator()(const Point& point) const {
  return {xx * point.x + xy * point.y + dx, yx * point.x + yy * point.y + dy};
}

Region transform(const Region& region, const Affine& map, const Options& options) {
  Cancellation cancellation(options);
  if (const std::optional<int> quarters = quarters_of(map)) {
    return turned_in_order(region, *quarters, cancellation);
  }
  return mapped(region, counting(map, cancellation));
}

Geometry transform(const Geometry& geometry, const Affine& map, const Options& options) {
  Cancellation cancellation(options);
  return mapped(geometry, transform(geometry.region, map, options), counting(map, cancellation));
}

Region reflect(const Region& region, const Options& options) {
  return transform(region, Affine::scaling(Rational(-1)), options);
}
Geometry reflect(const Geometry& geometry, const Options& options) {
  return transform(geometry, Affine::scaling(Rational(-1)), options);
}

}  // namespace minksum

#include "rounding/snap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "minksum/resolve.hpp"
#include "region/map_points.hpp"
#include "rounding/hot_pixels.hpp"

namespace minksum {
namespace {

Rational magnitude(const Rational& value) { return value.sign() < 0 ? -value : value; }

template <class Visit>
void for_each_point(const Geometry& geometry, Cancellation& cancellation, Visit visit) {
  const auto visit_one = [&](const Point& p) {
    cancellation.check(8 * work_of(p));
    visit(p);
  };
  for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
    visit_one(geometry.region.point(v));
  }
  for_each_thin_point(geometry, visit_one);
}

class Snapper {
 public:
  Snapper(const Geometry& geometry, const SnapGrid& grid, Cancellation& cancellation)
      : geometry_(geometry),
        grid_(grid),
        cancellation_(cancellation),
        points_(points_of(geometry, grid, cancellation)),
        pixels_(points_, cancellation) {}

  Snapped run() {
    Snapped result;
    Options options = part_of(cancellation_.options());
    options.fill = FillRule::kPositive;
    options.regularize = true;
    result.geometry.region = resolve(Geometry(snapped_rings()), options).region;
    if (geometry_.has_thin_parts()) {
      snap_thin_parts(result.geometry);
      options.fill = FillRule::kAutomatic;
      options.regularize = false;
      result.geometry = resolve(result.geometry, options);
    }
    measure(result);
    return result;
  }

 private:
  static std::vector<SnapPoint> points_of(const Geometry& geometry, const SnapGrid& grid,
                                          Cancellation& cancellation) {
    std::vector<SnapPoint> points;
    const Rational steps = Rational(1) / grid.step();
    for_each_point(geometry, cancellation,
                   [&](const Point& p) { points.push_back(snap_point(p.x * steps, p.y * steps)); });
    return points;
  }

  /// Returns every ring as a polygon of its own, because only winding numbers count.
  Region snapped_rings() {
    Region rings;
    const Region& region = geometry_.region;
    for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
      const IndexRange vertices = region.vertices_of(ring);
      chain_.clear();
      for (const std::size_t v : vertices) {
        extend_chain(v, v + 1 == vertices.front() + vertices.size() ? vertices.front() : v + 1);
      }
      chain_.pop_back();
      if (chain_.size() < 3) continue;  // a point, or an edge there and back
      rings.begin_polygon();
      rings.begin_ring();
      for (const PixelId pixel : chain_) {
        add_vertex(rings, place(pixels_.centre(pixel).x), place(pixels_.centre(pixel).y),
                   grid_.target);
      }
    }
    return rings;
  }

  void snap_thin_parts(Geometry& result) {
    std::size_t next = geometry_.region.vertex_count();
    for (const Polyline& line : geometry_.polylines) {
      chain_.clear();
      for (std::size_t i = 0; i + 1 < line.size(); ++i) extend_chain(next + i, next + i + 1);
      next += line.size();
      if (chain_.size() < 2) {
        if (!chain_.empty()) result.points.push_back(centre(chain_[0]));
        continue;
      }
      Polyline snapped;
      for (const PixelId pixel : chain_) snapped.push_back(centre(pixel));
      result.polylines.push_back(std::move(snapped));
    }
    for (std::size_t i = 0; i < geometry_.points.size(); ++i) {
      result.points.push_back(centre(pixels_.pixel_of(next + i)));
    }
  }

  /// Appends the chain that the edge between two points becomes. The pixel at the chain's end is
  /// not repeated.
  void extend_chain(std::size_t a, std::size_t b) {
    cancellation_.check(8);
    pixels_.list_met(points_[a], a, points_[b], b, cancellation_, met_);
    cancellation_.check(8 * met_.size());
    const bool apart = pixels_.pixel_of(a) != pixels_.pixel_of(b);
    bent_ |= met_.size() > (apart ? 2U : 1U);
    for (const PixelId pixel : met_) {
      if (chain_.empty() || chain_.back() != pixel) chain_.push_back(pixel);
    }
  }

  [[nodiscard]] RoundedCoordinate place(const BigInteger& centre) const {
    RoundedCoordinate place;
    if (grid_.target.is_decimal()) {
      place.integer = centre;
      return place;
    }
    const auto steps = static_cast<double>(static_cast<std::int64_t>(centre));
    place.value = std::ldexp(steps, grid_.exp2);
    if (!std::isfinite(place.value)) fail_beyond_doubles();
    return place;
  }
  [[nodiscard]] Point centre(PixelId pixel) const {
    const Vec<BigInteger>& centre = pixels_.centre(pixel);
    return {value_of(place(centre.x), grid_.target), value_of(place(centre.y), grid_.target)};
  }

  void measure(Snapped& result) const {
    double steps = bent_ ? rounded_up(std::sqrt(0.5)) : 0;
    for (const SnapPoint& p : points_) {
      if (p.offset.x.sign() == 0 && p.offset.y.sign() == 0) continue;
      steps = std::max(steps, rounded_up(length_of(p.near_offset.x, p.near_offset.y)));
    }
    result.exact = steps == 0;
    if (!result.exact) result.largest_move = rounded_up(steps * rounded_up(grid_.step()));
  }

  const Geometry& geometry_;
  const SnapGrid& grid_;
  Cancellation& cancellation_;
  std::vector<SnapPoint> points_;  ///< those of the region, the polylines, the points
  HotPixels pixels_;
  std::vector<PixelId> met_;
  std::vector<PixelId> chain_;
  bool bent_ = false;
};

}  // namespace

Rational SnapGrid::step() const {
  return target.is_decimal() ? target.unit() : RationalAccess::make(1, 1, exp2, 0);
}

SnapGrid snap_grid(const Geometry& geometry, const Target& target, Cancellation& cancellation) {
  SnapGrid grid{target, 0};
  if (target.is_decimal()) return grid;
  Rational largest;
  for_each_point(geometry, cancellation, [&](const Point& p) {
    largest = std::max({largest, magnitude(p.x), magnitude(p.y)});
  });
  constexpr int kLowest = -1074;
  grid.exp2 = kLowest;
  if (largest.sign() == 0) return grid;
  const double nearest = largest.to_double();
  if (!std::isfinite(nearest)) fail_beyond_doubles();
  if (nearest != 0) grid.exp2 = std::max(std::ilogb(nearest) - 52, kLowest);
  // All coordinates are below 2^53 steps, so they are rounded to 2^53 steps at most.
  return grid;
}

Snapped snap(const Geometry& geometry, const SnapGrid& grid, Cancellation& cancellation) {
  return Snapper(geometry, grid, cancellation).run();
}

}  // namespace minksum

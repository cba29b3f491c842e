#include "support/messes.hpp"

#include <cmath>
#include <vector>

#include "support/shapes.hpp"

namespace minksum::test {
namespace {

Point random_point(Random& random, int size) {
  const int x = random.between(0, size);
  return {Rational(x), Rational(random.between(0, size))};
}

std::vector<Point> random_points(Random& random, int count, int size) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    // Some edges lead back to where the previous one started.
    const bool again = points.size() > 1 && random.one_in(6);
    points.push_back(again ? points[points.size() - 2] : random_point(random, size));
  }
  return points;
}

}  // namespace

Geometry random_mess(Random& random) {
  Geometry mess;
  const int size = random.between(1, 6);
  for (int polygons = random.between(0, 3); polygons > 0; --polygons) {
    mess.region.begin_polygon();
    for (int rings = random.between(1, 4); rings > 0; --rings) {
      mess.region.begin_ring();
      for (const Point& p : random_points(random, random.between(1, 7), size)) {
        mess.region.add_vertex(p.x, p.y);
      }
    }
  }
  if (random.one_in(2)) mess.polylines.push_back(random_points(random, random.between(2, 5), size));
  if (random.one_in(3)) mess.points = random_points(random, random.between(1, 3), size);
  return mess;
}

std::function<Point(const Point&)> random_scaling(Random& random) {
  const int kind = random.below(5);
  const std::int64_t seed = random.between(1, 1000);
  const auto power = [](int exponent) { return Rational(std::ldexp(1.0, exponent)); };
  return [=](const Point& p) -> Point {
    switch (kind) {
      case 0:
        return p;
      case 1:
        return {p.x * Rational((std::int64_t{1} << 56) + seed), p.y * Rational(seed)};
      case 2:
        return {p.x * Rational(Decimal{seed, -7}) + 1, p.y * Rational(Decimal{3, -2}) - 5};
      case 3:
        return {p.x * power(70) + power(-30), p.y * power(-40)};
      default:
        return {p.x * power(900), p.y * power(-900)};
    }
  };
}

std::function<Point(const Point&)> random_projection(Random& random) {
  const int seed = random.between(1, 1000);
  return [=](const Point& p) -> Point {
    const Rational w = p.x * 3 + p.y * 5 + seed;
    return {p.x / w, p.y / w};
  };
}

Geometry transformed(const Geometry& geometry, const std::function<Point(const Point&)>& f) {
  Geometry result;
  result.region = transformed(geometry.region, f);
  for (const Polyline& line : geometry.polylines) {
    Polyline& moved = result.polylines.emplace_back();
    for (const Point& p : line) moved.push_back(f(p));
  }
  for (const Point& p : geometry.points) result.points.push_back(f(p));
  return result;
}

}  // namespace minksum::test

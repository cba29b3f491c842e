#include "rounding/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "region/point_arithmetic.hpp"

namespace minksum {
namespace {

Rational finite_value(const RoundedCoordinate& place, const Target& target) {
  if (!target.is_decimal() && !std::isfinite(place.value)) fail_beyond_doubles();
  return value_of(place, target);
}

/// Returns the two places around a coordinate, or the coordinate twice if it is a place itself.
std::pair<Rational, Rational> places_around(const Rational& value, const Target& target) {
  const RoundedCoordinate nearest = nearest_place(value, target);
  Rational place = finite_value(nearest, target);
  if (place == value) return {place, place};
  const bool up = place < value;
  Rational other = finite_value(next_place(nearest, up, target), target);
  return up ? std::pair{place, other} : std::pair{other, place};
}

Rational next_up(const Rational& value, const Target& target) {
  return finite_value(next_place(nearest_place(value, target), true, target), target);
}

bool is_place(const Rational& value, const Target& target) {
  if (target.is_decimal()) return (value / target.unit()).is_integer();
  const double nearest = value.to_double();
  return std::isfinite(nearest) && Rational(nearest) == value;
}

bool turns_left(const Point& a, const Point& b, const Point& c) {
  return cross(minus(b, a), minus(c, a)).sign() > 0;
}

}  // namespace

Cell cell_around(const Point& p, const Target& target) {
  auto [left, right] = places_around(p.x, target);
  auto [bottom, top] = places_around(p.y, target);
  return {{left, bottom}, {right, top}};
}

Cell thickened(Cell cell, const Target& target) {
  if (cell.low.x == cell.high.x) cell.high.x = next_up(cell.low.x, target);
  if (cell.low.y == cell.high.y) cell.high.y = next_up(cell.low.y, target);
  return cell;
}

bool is_on_target(const Point& p, const Target& target) {
  return is_place(p.x, target) && is_place(p.y, target);
}

double farthest_corner(const Cell& cell, const Point& p) {
  const double x = rounded_up(std::max(p.x - cell.low.x, cell.high.x - p.x));
  const double y = rounded_up(std::max(p.y - cell.low.y, cell.high.y - p.y));
  const double far = length_of(x, y);
  return far == 0 ? 0 : rounded_up(far);
}

// The algorithm is that of A. M. Andrew, "Another efficient algorithm for convex hulls in two
// dimensions", Inf. Process. Lett. 9, 1979.
Ring hull_of(const Cell& a, const Cell& b) {
  std::array<Point, 8> corners;
  std::size_t count = 0;
  for (const Cell* cell : {&a, &b}) {
    corners[count++] = cell->low;
    corners[count++] = {cell->high.x, cell->low.y};
    corners[count++] = cell->high;
    corners[count++] = {cell->low.x, cell->high.y};
  }
  std::sort(corners.begin(), corners.end(), comes_before);
  const auto end = std::unique(corners.begin(), corners.end());
  if (end - corners.begin() == 1) return {corners[0]};
  Ring hull;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
      while (hull.size() > start + 1 && !turns_left(hull[hull.size() - 2], hull.back(), *first)) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();  // the other chain starts there
  };
  add_chain(corners.begin(), end);
  add_chain(std::make_reverse_iterator(end), corners.rend());
  return hull;
}

}  // namespace minksum

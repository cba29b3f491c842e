#include "rounding/orientation.hpp"

#include <algorithm>
#include <cmath>

#include "exact/formulas.hpp"
#include "exact/sign.hpp"
#include "region/point_arithmetic.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

/// Orders vertices by x, then by y.
bool before(const Region& region, std::size_t a, std::size_t b) {
  const auto by_x =
      RegionAccess::compare(region, RegionAccess::x(region, a), RegionAccess::x(region, b));
  if (by_x != 0) return by_x < 0;
  return RegionAccess::compare(region, RegionAccess::y(region, a), RegionAccess::y(region, b)) < 0;
}

Vec<double> nearest(const Region& region, std::size_t v) { return {region.x(v), region.y(v)}; }

/// Returns the side of the line from a to b on which p lies.
Sign side(const Region& region, std::size_t a, std::size_t b, std::size_t p) {
  const Vec<double> from = nearest(region, a);
  const Vec<double> to = nearest(region, b);
  const Vec<double> at = nearest(region, p);
  double largest = 0;
  for (const double c : {from.x, from.y, to.x, to.y, at.x, at.y}) {
    largest = std::max(largest, std::abs(c));
  }
  // Let M be the largest magnitude. Differences are off by M·2^-51 at most, and so two products of
  // differences by less than M²·2^-47. Their roundings are less than that, too.
  const double value =
      cross(Vec<double>{to.x - from.x, to.y - from.y}, Vec<double>{at.x - from.x, at.y - from.y});
  const bool usable = largest > 0x1p-400 && largest < 0x1p400;
  if (usable && std::abs(value) > largest * largest * 0x1p-46) return sign_of(value);
  const Point start = region.point(a);
  return sign_of(cross(minus(region.point(b), start), minus(region.point(p), start)).sign());
}

}  // namespace

bool counter_clockwise(const Region& region, std::size_t ring, Cancellation& cancellation) {
  const IndexRange vertices = region.vertices_of(ring);
  const std::size_t n = vertices.size();
  std::size_t lowest = vertices.front();
  for (const std::size_t v : vertices) {
    cancellation.check(2 * work_of_product(RegionAccess::bits(region, v)));
    if (before(region, v, lowest)) lowest = v;
  }
  // The ring turns at its smallest vertex, between the nearest different vertices on both sides.
  const auto differs = [&](std::size_t v) {
    if (region.x(v) != region.x(lowest) || region.y(v) != region.y(lowest)) return true;
    return !(region.point(v) == region.point(lowest));
  };
  const auto neighbour = [&](std::size_t step) {
    std::size_t i = lowest - vertices.front();
    for (std::size_t k = 0; k < n; ++k) {
      i = (i + step) % n;
      if (differs(vertices.front() + i)) return vertices.front() + i;
    }
    return lowest;
  };
  const std::size_t next = neighbour(1);
  const std::size_t previous = neighbour(n - 1);
  return side(region, lowest, next, previous) == kPositive;
}

}  // namespace minksum

#include "rounding/orientation.hpp"

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
  const Point at = region.point(lowest);
  const auto neighbour = [&](std::size_t step) {
    std::size_t i = lowest - vertices.front();
    for (std::size_t k = 0; k < n; ++k) {
      i = (i + step) % n;
      Point other = region.point(vertices.front() + i);
      if (!(other == at)) return other;
    }
    return at;
  };
  const Point next = neighbour(1);
  const Point previous = neighbour(n - 1);
  return cross(minus(next, at), minus(previous, at)).sign() > 0;
}

}  // namespace minksum

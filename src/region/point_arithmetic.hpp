// Defines the order of exact points and arithmetic with them as vectors, and visits edges.
#pragma once

#include "minksum/region.hpp"

namespace minksum {

/// Orders points by x, then by y.
[[nodiscard]] inline bool comes_before(const Point& a, const Point& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

[[nodiscard]] inline Point plus(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Rational dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline Rational cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}

/// Calls visit(v, w) for each edge of a region's rings, where v and w are its vertices' indices.
template <class Visit>
void for_each_edge(const Region& region, Visit visit) {
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    const IndexRange vertices = region.vertices_of(ring);
    const std::size_t last = vertices.front() + vertices.size() - 1;
    for (const std::size_t v : vertices) visit(v, v == last ? vertices.front() : v + 1);
  }
}

}  // namespace minksum

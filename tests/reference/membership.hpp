// Membership by the definition, without any sum being computed.
#pragma once

#include "reference/exact.hpp"

namespace minksum::reference {

/// Where a point is with respect to a valid region.
[[nodiscard]] Side locate(const Pt& p, const Region& region);

/// Is x in P ⊕ Q (closed)? It is iff P meets x - Q. Every edge against every edge.
[[nodiscard]] bool contains_sum(const Region& p, const Region& q, const Pt& x);

/// A point strictly inside a polygon: an outer ring, and holes. Rings in any orientation.
[[nodiscard]] Pt point_strictly_inside(const Loops& polygon);

/// Points close to the boundary of a region, on both sides of each edge's midpoint, and on it.
[[nodiscard]] std::vector<Pt> points_near_edges(const Region& region, const Number& distance);

}  // namespace minksum::reference

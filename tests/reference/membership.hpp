// Tests membership by the definition, without computing any sum.
#pragma once

#include "reference/exact.hpp"

namespace minksum::reference {

/// Returns on which side of the boundary of a valid region a point lies.
[[nodiscard]] Side locate(const Pt& p, const Region& region);

/// Returns whether x is in the closed set P ⊕ Q, that is, whether P meets x - Q. Tests every edge
/// against every edge.
[[nodiscard]] bool contains_sum(const Region& p, const Region& q, const Pt& x);

/// Returns a point strictly inside a polygon, which is an outer ring and holes in any orientation.
[[nodiscard]] Pt point_strictly_inside(const Loops& polygon);

/// Returns points close to the boundary of a region, on both sides of each edge's midpoint and on
/// it.
[[nodiscard]] std::vector<Pt> points_near_edges(const Region& region, const Number& distance);

}  // namespace minksum::reference

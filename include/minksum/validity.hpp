// Is a region a legal operand, and if not, where not?
#pragma once

#include <string>
#include <vector>

#include "minksum/region.hpp"

namespace minksum {

/// One fault of a region.
struct Fault {
  std::string message;  ///< what is wrong, in words
  Culprit place;        ///< polygon, ring and vertex; `operand` is -1
  double x = 0;         ///< about where (the vertex named, or where two edges meet)
  double y = 0;
};

/// All reasons why `region` is no legal operand, at most `max_faults` of them; none = legal.
///
/// Legal are the polygons and multipolygons that OGC calls valid: rings of three or more vertices
/// not all in one line, each a simple closed curve; no two rings cross or share a piece of an edge
/// (touching at points is fine); holes inside their outer ring and not inside each other; polygons
/// with disjoint interiors. Orientation, repeated vertices and vertices in the middle of straight
/// edges do not matter. Wider than OGC: rings of one polygon may touch at several points.
/// O(n log n + k) for n vertices and k close pairs of edges. Throws Error(kLimitExceeded) for more
/// than 2^30 vertices, or somewhat fewer if edges are long.
[[nodiscard]] std::vector<Fault> validate(const Region& region, std::size_t max_faults = 100);

}  // namespace minksum

// Is a region a valid operand, and if not, where not?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "minksum/export.h"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// One fault of a region. `Culprit::operand` is -1 in both places.
struct Fault {
  std::string message;  ///< what is wrong, in words: "edges cross"
  /// The vertex that is wrong, or the first vertex of an edge that is.
  Culprit place;
  /// The vertex or edge that it meets; unknown (`Culprit::kNone`) where nothing is met.
  Culprit other;
  /// Exactly where: the crossing of two edges, the first point that two edges share, or the vertex.
  /// Nothing for a ring without vertices.
  std::optional<Point> at;
};
/// What is wrong and where: "edges cross at (5, 1/2)"; "near (0.3, 7.1)" if the exact numbers are
/// long.
[[nodiscard]] MINKSUM_API std::string to_string(const Fault& fault);

/// All reasons why `region` is no valid operand, at most `max_faults` of them; none = valid. Every
/// two edges that cross or overlap are a fault of their own.
///
/// Valid are the polygons and multipolygons that OGC calls valid: rings of three or more vertices
/// not all in one line, each a simple closed curve; no two rings cross or share a piece of an edge
/// (touching at points is fine); holes inside their outer ring and not inside each other; polygons
/// with disjoint interiors. Orientation, repeated vertices and vertices in the middle of straight
/// edges do not matter. Wider than OGC: rings of one polygon may touch at several points.
/// O(n log n + k) for n vertices and k close pairs of edges. Throws Error(kLimitExceeded) for more
/// than 2^30 vertices, or somewhat fewer if edges are long; Error(kCancelled).
[[nodiscard]] MINKSUM_API std::vector<Fault> validate(const Region& region,
                                                      std::size_t max_faults = 100,
                                                      const Options& options = {});

}  // namespace minksum

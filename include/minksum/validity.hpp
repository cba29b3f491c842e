// Declares the test that tells whether a region is a valid operand, and if not, where it is not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "minksum/export.h"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// One fault of a region. `Culprit::operand` is -1 in `place` and in `other`.
struct Fault {
  std::string message;  ///< what is wrong, such as "edges cross"
  /// The vertex that is wrong, or the first vertex of the edge that is wrong.
  Culprit place;
  /// The vertex or edge that `place` meets; `Culprit::kNone` where nothing is met.
  Culprit other;
  /// The exact location: the crossing of two edges, the first point that two edges share, or the
  /// vertex. It is empty for a ring without vertices.
  std::optional<Point> at;
};
/// Returns what is wrong and where: "edges cross at (5, 1/2)". If the exact numbers are long, it
/// ends with rounded ones: "near (0.3, 7.1)".
[[nodiscard]] MINKSUM_API std::string to_string(const Fault& fault);

/// Returns the reasons why `region` is not a valid operand, at most `max_faults` of them. There is
/// none if the region is valid. Each pair of edges that cross or overlap is a fault of its own.
///
/// Valid are the polygons and multipolygons that the OGC calls valid:
/// - Each ring is a simple closed curve of three or more vertices that do not lie in one line.
/// - No two rings cross or share a piece of an edge. Rings may touch at points.
/// - Holes lie inside their outer ring, and not inside each other.
/// - Polygons have disjoint interiors.
///
/// Orientation, repeated vertices, and vertices in the middle of straight edges do not matter. One
/// rule is wider than the OGC's: rings of one polygon may touch at several points.
///
/// Takes O(n log n) time and O(n) memory for n vertices of a valid region, wherever they lie. In
/// other regions, an edge that meets another one wrongly is compared with all edges in the cells
/// that it passes, until enough faults are found. Up to sqrt(n) cells lie along a side. Throws
/// Error(kLimitExceeded) for more than 2^30 vertices, or for somewhat fewer if edges are long and
/// some meet wrongly. Throws Error(kCancelled).
[[nodiscard]] MINKSUM_API std::vector<Fault> validate(const Region& region,
                                                      std::size_t max_faults = 100,
                                                      const Options& options = {});

}  // namespace minksum

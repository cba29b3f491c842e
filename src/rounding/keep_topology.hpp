// Checks whether a region keeps its rings and holes when its vertices move a little.
#pragma once

#include "machine/cancellation.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

enum class TopologyVerdict {
  kKept,     ///< valid by the OGC's rules, with the same polygons and holes
  kCut,      ///< rings are valid, but some polygon's interior is in pieces
  kInvalid,  ///< rings cross, collapse, turn over or lie where they must not
};

struct TopologyCheck {
  TopologyVerdict outcome = TopologyVerdict::kInvalid;
  Region region;  ///< canonical unless invalid; if cut, the valid region as it is
};

/// Judges a region that came from the valid region `exact` by moving vertices, ring by ring and
/// vertex by vertex. The topology is kept if each ring is a simple curve with its old orientation,
/// and the polygons still have their holes and connected interiors. Rings may have come to touch at
/// points. Decided exactly, in the time of `validate`.
///
/// Take a polygon whose rings touch only at points. Join rings and points where a point is on a
/// ring. The interior is connected if and only if this graph has no cycle. A cycle is a closed
/// curve in the polygon's boundary with interior on both sides. Without a cycle, each hole can be
/// taken away in turn, as an area that touches the rest in one point at most.
[[nodiscard]] TopologyCheck check_topology(const Region& exact, const Region& moved,
                                           Cancellation& cancellation);

}  // namespace minksum

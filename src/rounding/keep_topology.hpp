// Is a region still what it was, after its vertices were moved a little?
#pragma once

#include "machine/cancellation.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

enum class TopologyVerdict {
  kKept,     ///< valid by OGC's rules, with the same polygons and holes
  kCut,      ///< rings are valid, but the interior of some polygon is in pieces
  kInvalid,  ///< rings cross, collapse, turn over or lie where they must not
};

struct TopologyCheck {
  TopologyVerdict outcome = TopologyVerdict::kInvalid;
  Region region;  ///< canonical, unless invalid; of a cut one, the valid region as it is
};

/// Judges a region that came from the valid region `exact` by moving vertices, ring by ring and
/// vertex by vertex. Kept means: each ring is a simple curve of the orientation that it had, and
/// together they are what they were, polygons with holes, each with a connected interior. Rings may
/// have come to touch at points. Decided exactly, in the time of `validate`.
///
/// Of a polygon whose rings touch at points only the interior is connected iff rings and points,
/// joined where a point is on a ring, make no cycle: a cycle is a closed curve in the polygon's
/// boundary with interior on both sides; without any, each hole can be taken away in turn, as an
/// area that touches the rest in one point at most.
[[nodiscard]] TopologyCheck check_topology(const Region& exact, const Region& moved,
                                           Cancellation& cancellation);

}  // namespace minksum

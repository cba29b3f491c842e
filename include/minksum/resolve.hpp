// From rings of any kind to the set of points that they mean.
#pragma once

#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/export.h"
#include "minksum/geometry.hpp"

namespace minksum {

/// Which points a set of rings encloses, told by their winding number w: how often all rings
/// together go counter-clockwise around the point.
enum class FillRule {
  /// Each polygon is what its outer ring encloses or passes through, less what its holes enclose.
  /// The set is the union of all polygons. So a hole only ever takes away, and valid polygons (see
  /// `validate`) mean what OGC says. A ring encloses the points around which it winds, whatever its
  /// direction. A hole does not take away its own ring: where two holes share an edge, that edge
  /// stays as a polyline. Single points that holes leave between them do not stay.
  kAutomatic,
  kEvenOdd,   ///< w is odd
  kNonZero,   ///< w is not 0; rings directed as they are given, and so for the next two
  kPositive,  ///< w > 0
  kNegative,  ///< w < 0
  kStrict,    ///< polygons must be valid: else Error(kBadInput) that names the fault's place
};
/// "automatic", "evenodd", "nonzero", "positive", "negative", "strict".
[[nodiscard]] MINKSUM_API const char* to_string(FillRule rule);

struct ResolveOptions {
  FillRule fill = FillRule::kAutomatic;
  /// Drops what has no area: polylines, points, and the thin parts of rings.
  bool regularize = false;
  std::optional<CancelToken> cancel = {};
  int operand = -1;  ///< which operand errors name (Culprit::operand)
};

/// The set of points that a geometry means, in resolved form (see Geometry), exactly.
///
/// Its area is the closure of the points that the fill rule says. A ring's own points belong to the
/// set (by kAutomatic, what holes take away excepted), so spikes, antennas and rings that collapse
/// become polylines or points where no area holds them. Where rings cross, vertices are rational
/// points. O((n + c) log n) for n vertices and c places where edges meet. Throws Error: kBadInput
/// (kStrict), kLimitExceeded, kCancelled.
[[nodiscard]] MINKSUM_API Geometry resolve(const Geometry& geometry,
                                           const ResolveOptions& options = {});

}  // namespace minksum

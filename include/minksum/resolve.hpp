// From rings of any kind to the set of points that they mean.
#pragma once

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// The set of points that a geometry means, in resolved form (see Geometry), exactly.
///
/// Its area is the closure of the points that the fill rule says. A ring's own points belong to the
/// set (by kAutomatic, what holes take away excepted), so spikes, antennas and rings that collapse
/// become polylines or points where no area holds them. Where rings cross, vertices are rational
/// points. If `options.regularize` is set, what has no area is dropped. O((n + c) log n) for n
/// vertices and c places where edges meet. Throws Error: kBadInput (kStrict), with `operand` as its
/// culprit's, kLimitExceeded, kCancelled.
[[nodiscard]] MINKSUM_API Geometry resolve(const Geometry& geometry, const Options& options = {},
                                           int operand = -1);

}  // namespace minksum

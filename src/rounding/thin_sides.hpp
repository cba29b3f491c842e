// Rounds geometries with thin parts so that no point is lost, or so that none is gained.
#pragma once

#include "minksum/round.hpp"
#include "rounding/round_region.hpp"

namespace minksum {

/// Tells whether all coordinates are in the target.
[[nodiscard]] bool is_on_target(const Geometry& geometry, const Target& target,
                                const Options& options);

/// Returns √2 · u, rounded up, where u is the largest side of a cell. No corner of a cell around a
/// point of the thin parts is farther from the point.
[[nodiscard]] double cell_bound(const Geometry& geometry, const Target& target,
                                const Options& options);

/// Returns a resolved geometry of the target that contains the exact one, which is resolved, too.
/// The report lacks `topology_kept`. `largest_move` may exceed `bound`, because both are upper
/// bounds.
///
/// Every segment of a polyline is replaced by the convex hull of the cells around its ends, and a
/// point by its cell. Hulls that have area are united with the region, which is rounded to the
/// outside. The other hulls are *kept*: they are segments and points of the target, and contain
/// what they replace.
///
/// A kept segment may meet another one, or the rounded region, at a point that is not in the
/// target. Then its parts outside the region are replaced as well, with cells that have area; and
/// so on. Kept parts are never taken back, so the result contains the exact geometry. If this does
/// not end soon, everything is grown and snap-rounded (see grow.hpp).
///
/// Let u be the largest side of a cell. The hulls reach no farther than √2 · u from what they
/// replace, and the region moves by no more than that. So the bound is 2√2 · u, or √2 · u if no
/// hull was made.
[[nodiscard]] Geometry round_outside(const Geometry& geometry, const Target& target,
                                     const RoundRequest& request, RoundingReport& report);

/// Returns a resolved geometry of the target that the exact one contains, which is resolved, too.
/// The result has the region rounded to the inside, the points in the target, and the segments with
/// both ends in the target. If another segment is along an axis, its longest part with such ends
/// remains. If it is not, its ends in the target remain as points. The report is that of the region,
/// but for `exact`.
[[nodiscard]] Geometry round_inside(const Geometry& geometry, const Target& target,
                                    const RoundRequest& request, RoundingReport& report);

}  // namespace minksum

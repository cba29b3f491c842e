// Geometries with thin parts, so that no point is lost, or so that none is won.
#pragma once

#include "minksum/round.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

template <class Visit>
void for_each_thin_point(const Geometry& geometry, Visit visit) {
  for (const Polyline& line : geometry.polylines) {
    for (const Point& p : line) visit(p);
  }
  for (const Point& p : geometry.points) visit(p);
}

/// Whether all coordinates are of the target.
[[nodiscard]] bool is_on_target(const Geometry& geometry, const Target& target,
                                const std::optional<CancelToken>& cancel);

/// √2 · u, rounded up: no corner of a cell around a point of the thin parts is farther from it.
[[nodiscard]] double cell_bound(const Geometry& geometry, const Target& target,
                                const std::optional<CancelToken>& cancel);

/// A resolved geometry of the target that contains the exact one. The report lacks `topology_kept`,
/// and `largest_move` may be beyond `bound`: both are upper bounds.
///
/// Every segment of a polyline is replaced by the convex hull of the cells around its ends, and a
/// point by its cell. What of these has area is united with the region, which is rounded to the
/// outside. The others are *kept*: segments and points of the target, each of which contains what
/// it replaces. Where one of these meets another, or the rounded region, at a point that is not of
/// the target, what is left of it outside of the region is replaced as well, with cells that have
/// area; and so on. What is kept is never taken back, so that all of them contain the exact
/// geometry. If there is no end to it soon, everything is grown and snap-rounded (see grow.hpp).
///
/// With u for the largest side of a cell, the hulls reach no farther than √2 · u from what they
/// replace, and the region moves by no more than that: the bound is 2√2 · u, or √2 · u if no hull
/// was made.
[[nodiscard]] Geometry round_outside(const Geometry& geometry, const Target& target,
                                     const RoundOptions& options, RoundingReport& report);

/// A resolved geometry of the target that is contained in the exact one: the region rounded to the
/// inside, points of the target, segments with such ends, the longest such part of a segment along
/// an axis, and of others the ends that are of the target, as points. The report is that of the
/// region, but for `exact`. Throws Error(kBadInput) if it finds that the geometry is not resolved.
[[nodiscard]] Geometry round_inside(const Geometry& geometry, const Target& target,
                                    const RoundOptions& options, RoundingReport& report);

}  // namespace minksum

// Declares rounding of an exact set to doubles or decimals, so that it stays valid.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// Says to which side of the exact set a result may deviate.
enum class RoundingSide {
  kNearest,  ///< to both sides, as little as possible
  kOutside,  ///< outwards: the result contains the exact set
  kInside,   ///< inwards: the exact set contains the result
};
/// Returns the side's name: "nearest", "outside" or "inside"; or "unknown".
[[nodiscard]] MINKSUM_API const char* to_string(RoundingSide side);

/// The largest number of digits after the point for rounding and for writing.
inline constexpr int kMaxDecimals = 4096;

/// Says to which numbers, and to which side, a set is rounded.
struct RoundOptions {
  RoundingSide side = RoundingSide::kNearest;  ///< the side to which the result may deviate
  /// Digits after the point, 0 to kMaxDecimals. If it is not set, the result has doubles.
  std::optional<int> decimals = {};
};

/// Tells what rounding did.
struct RoundingReport {
  bool exact = false;    ///< whether nothing had to be rounded
  bool snapped = false;  ///< whether rounding vertex by vertex would not have been valid or safe
  /// Whether the result has as many polygons, polylines and points as the exact set, and each
  /// polygon as many holes.
  bool topology_kept = false;
  /// An upper bound on how far the boundary moved, rounded up. No boundary point of the result is
  /// farther than this from the exact boundary. No point that only one of the two sets has is
  /// farther from either boundary. Thin parts count as boundary, except those that disappear.
  double largest_move = 0;
  double bound = 0;  ///< the most that `largest_move` can be
};

/// Returns a region near the exact one whose coordinates are doubles, or decimals with a given
/// number of digits. These numbers are the *target*. The result is valid by the OGC's rules and
/// canonical (see Region). The exact region must be valid (see `validate`).
///
/// Let u be a decimal step, or the last place of the largest coordinate as a double.
/// - kNearest: if the region stays valid and its rings keep their orientation, every coordinate
///   goes to the nearest number by itself. `bound` is u/√2. Otherwise the boundary is snap-rounded
///   (Hobby 1999; Guibas, Marimont 1998), with the same `bound`. Vertices go to the nearest points
///   of a grid of step u, and edges to the rounded vertices that they pass closely, so that nothing
///   crosses. What collapses disappears.
/// - kOutside, kInside: vertices that are already in the target stay. Every other vertex goes to a
///   corner of its cell of the target, so that no edge moves inwards (outwards). If there is no
///   such choice, or the result would not be valid, the region is grown (shrunk) by u/2 along each
///   axis and then snap-rounded. `bound` is u·√2.
///
/// Thin parts of a geometry, polylines and points, are rounded as follows. To a side, the geometry
/// is resolved first.
/// - kNearest: every point goes to the nearest one by itself. If parts would cross each other, or
///   meet a region that moves, everything is snap-rounded together.
/// - kOutside: what is in the target stays. Any other point becomes the cell of the target around
///   it. Any other segment becomes the convex hull of the cells around its ends. A hull has area
///   unless it is a point or a segment along an axis. Remaining pieces that end outside of the
///   target, at the rounded region or where they cross, become hulls as well. All areas are then
///   rounded as one region, and `bound` is at most 2√2·u. If more and more such pieces arise,
///   everything is grown by u/2 and snap-rounded instead, and `bound` is u·√2.
/// - kInside: points in the target stay, and so do segments whose ends are in the target. Of any
///   other segment along an axis, the part between the outermost points in the target stays. Of all
///   others, the ends in the target stay as points. Everything else disappears.
///
/// O(n log n) for n vertices if nothing has to be snapped. Otherwise it takes the time of
/// `resolve`, and for a side that of a sum with a square. Thin parts take a few times as long as
/// `resolve`, where hulls may overlap.
///
/// Throws Error: kBadInput for a region that is not valid, with polygon, ring and vertex; kBadInput
/// for a number of digits out of range; kLimitExceeded, also if a coordinate or its rounded value
/// is beyond the range of doubles; kCancelled.
[[nodiscard]] MINKSUM_API Region round(const Region& region, const RoundOptions& target = {},
                                       const Options& options = {});
/// Returns the same for a geometry with thin parts.
[[nodiscard]] MINKSUM_API Geometry round(const Geometry& geometry, const RoundOptions& target = {},
                                         const Options& options = {});

/// Returns the rounded set that a geometry means by `options.fill`, and keeps tight places as
/// `resolve_with_tight_places` does. These are rounded to the nearest, whatever the side. So one on
/// the boundary may leave a set that is rounded inwards, by no more than `bound` for kNearest.
/// Complexity and errors are those of `resolve` and of `round`.
[[nodiscard]] MINKSUM_API Geometry round_with_tight_places(const Geometry& geometry,
                                                           const RoundOptions& target = {},
                                                           const Options& options = {});

/// A rounded set, and what rounding did to it.
struct Rounded {
  Geometry geometry;      ///< the rounded set; a rounded region is `geometry.region`
  RoundingReport report;  ///< what rounding did
};
/// Returns what `round` returns, with a report. Complexity and errors are the same.
[[nodiscard]] MINKSUM_API Rounded detailed_round(const Region& region,
                                                 const RoundOptions& target = {},
                                                 const Options& options = {});
/// Returns the same for a geometry with thin parts.
[[nodiscard]] MINKSUM_API Rounded detailed_round(const Geometry& geometry,
                                                 const RoundOptions& target = {},
                                                 const Options& options = {});

}  // namespace minksum

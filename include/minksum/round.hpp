// Rounding an exact set to doubles or decimals, so that it stays valid.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// To which side a result may be off.
enum class RoundingSide {
  kNearest,  ///< as close as can be
  kOutside,  ///< the result certainly contains the exact set, every point of it
  kInside,   ///< the result is certainly contained in it
};
/// "nearest", "outside", "inside".
[[nodiscard]] MINKSUM_API const char* to_string(RoundingSide side);

/// The most digits after the point to which coordinates are rounded, or with which they are written.
inline constexpr int kMaxDecimals = 4096;

/// What is rounded to.
struct RoundOptions {
  RoundingSide side = RoundingSide::kNearest;  ///< to which side
  /// Digits after the point, 0 to kMaxDecimals; without it, to doubles.
  std::optional<int> decimals = {};
};

/// What rounding did.
struct RoundingReport {
  bool exact = false;    ///< nothing had to be rounded
  bool snapped = false;  ///< vertex by vertex would not have been valid, or not safe
  /// As many polygons, each with as many holes, as the exact region; as many polylines and points.
  bool topology_kept = false;
  /// No boundary point of the result is farther than this from the exact boundary, and no point
  /// farther from either that belongs to one of the two sets only. Thin parts are boundary: of
  /// those that go, this says nothing. Rounded up.
  double largest_move = 0;
  double bound = 0;  ///< what `largest_move` cannot exceed
};

/// A region whose coordinates are doubles, or decimals with so many digits; valid by OGC's rules,
/// and canonical (see Region). The exact one must be valid (see `validate`).
///
/// Let u be a decimal step, or the last place of the coordinates' largest as a double.
/// - kNearest: every coordinate to the nearest by itself, if that keeps the region valid and its
///   rings as they are oriented: `bound` is u/√2. Else the boundary is snap-rounded (Hobby 1999;
///   Guibas, Marimont 1998): vertices to the nearest points of a grid of step u, and edges to the
///   rounded vertices that they pass closely, so that nothing crosses; what collapses goes. `bound`
///   is the same.
/// - kOutside, kInside: every vertex that has to move goes to a corner of its cell of the target,
///   chosen such that no edge moves inwards (outwards), if there is such a choice and the region
///   stays valid. Vertices that are of the target stay. Else the region is grown (shrunk) by u/2
///   along each axis and snap-rounded. `bound` is u·√2.
///
/// Thin parts of a geometry (polylines, points), which must be resolved:
/// - kNearest: every point to the nearest by itself; where parts meet a region that moves, or would
///   cross one another, all is snap-rounded together.
/// - kOutside: what is of the target stays as it is. A point becomes the cell of the target that it
///   is in, a segment the convex hull of the cells that its ends are in: area, unless that hull is
///   a segment along an axis or a point. So do pieces of the others that end, at the rounded region
///   or where they cross, between places of the target. All areas together are rounded as a region:
///   `bound` is up to 2√2·u then. If that leads to more and more such pieces, everything, thin or
///   not, is grown by u/2 and snap-rounded: `bound` is u·√2.
/// - kInside: what is of the target stays: points, and polylines from vertex to vertex. Of a
///   segment along an axis the part between the outermost places stays; of any other, its ends, as
///   points, if they are of the target. The rest goes.
///
/// O(n log n) for n vertices where nothing has to be snapped, as `validate`; else that of a sum
/// with a square (for a side) and of `resolve`. Thin parts take a few times that of `resolve`,
/// where hulls may overlap. Throws Error: kBadInput if the region is not valid; kLimitExceeded,
/// also if a coordinate or its rounded value is beyond the range of doubles; kCancelled.
[[nodiscard]] MINKSUM_API Region round(const Region& region, const RoundOptions& target = {},
                                       const Options& options = {});
/// The same with thin parts.
[[nodiscard]] MINKSUM_API Geometry round(const Geometry& geometry, const RoundOptions& target = {},
                                         const Options& options = {});

/// A rounded set, and what rounding did to it.
struct Rounded {
  Geometry geometry;      ///< the rounded set; of a region, its region
  RoundingReport report;  ///< what was done
};
/// As `round`, with the report.
[[nodiscard]] MINKSUM_API Rounded detailed_round(const Region& region,
                                                 const RoundOptions& target = {},
                                                 const Options& options = {});
/// The same with thin parts.
[[nodiscard]] MINKSUM_API Rounded detailed_round(const Geometry& geometry,
                                                 const RoundOptions& target = {},
                                                 const Options& options = {});

}  // namespace minksum

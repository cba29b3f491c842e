// Rounding an exact region to doubles or decimals, so that it stays valid.
#pragma once

#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/geometry.hpp"

namespace minksum {

enum class RoundingSide {
  kNearest,  ///< as close as can be
  kOutside,  ///< the result certainly contains the exact region
  kInside,   ///< the result is certainly contained in it
};
/// "nearest", "outside", "inside".
[[nodiscard]] const char* to_string(RoundingSide side);

struct RoundOptions {
  RoundingSide side = RoundingSide::kNearest;
  /// Digits after the point; without it, to doubles.
  std::optional<int> decimals;
  std::optional<CancelToken> cancel;
};

/// What rounding did.
struct RoundingReport {
  bool exact = false;          ///< nothing had to be rounded
  bool snapped = false;        ///< coordinate by coordinate would not have been valid, or not safe
  bool topology_kept = false;  ///< as many polygons, each with as many holes, as the exact region
  double largest_move = 0;     ///< of the boundary, rounded up: no point of either is further off
  double bound = 0;            ///< what `largest_move` cannot exceed
};

/// A region whose coordinates are doubles, or decimals with so many digits; valid by OGC's rules.
///
/// With kNearest every coordinate is the nearest one by itself, if that keeps the region valid and its
/// topology; else the boundary is snap-rounded (Hobby 1999; Guibas, Marimont 1998): every vertex and
/// every crossing to the nearest point of a uniform grid, and edges to the rounded vertices that they
/// pass, so that nothing crosses; what collapses is dropped. `bound` says how far that can move.
/// kOutside and kInside grow or shrink the region by as little as makes the rounding safe.
/// Thin parts of a geometry are rounded to the nearest, whatever the side.
/// Throws Error: kBadInput if a coordinate is beyond the doubles, kCancelled.
[[nodiscard]] Region round(const Region& region, const RoundOptions& options = {},
                           RoundingReport* report = nullptr);
[[nodiscard]] Geometry round(const Geometry& geometry, const RoundOptions& options = {},
                             RoundingReport* report = nullptr);

}  // namespace minksum

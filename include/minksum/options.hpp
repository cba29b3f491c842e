// Declares what a caller decides about an operation. All operations share this type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/export.h"

namespace minksum {

class Workspace;

/// Says which points a set of rings encloses. Most rules use the winding number w of a point: how
/// often all rings together go counter-clockwise around the point. Clockwise turns count negative.
enum class FillRule {
  /// The union of all polygons, where each polygon is the area of its outer ring without its holes.
  /// Valid polygons (see `validate`) thus mean what the OGC says, and a hole only takes area away.
  /// A ring encloses the points around which it winds, in either direction. An outer ring itself
  /// belongs to its polygon. A hole does not take away its own ring: an edge that two holes share
  /// stays as a polyline. Single points that holes leave between them do not stay.
  kAutomatic,
  kEvenOdd,   ///< w is odd
  kNonZero,   ///< w is not 0; rings keep their given directions, here and below
  kPositive,  ///< w > 0
  kNegative,  ///< w < 0
  kStrict,    ///< polygons must be valid, else Error(kBadInput) with the first fault's place
};
/// Returns the rule's name: "automatic", "evenodd", "nonzero", "positive", "negative" or "strict".
/// It is "unknown" for an integer that was cast to the type and is none of the rules.
[[nodiscard]] MINKSUM_API const char* to_string(FillRule rule);

/// Limits on one sum. Exceeding one is an Error(kLimitExceeded) that names the limit. No method
/// takes more than 2^30 of either, whatever is set.
struct Limits {
  /// Convolution segments that are listed. All segments are listed, unless there are very many:
  /// then only those are listed that may touch an uncovered cell. Segments that are only counted
  /// are not limited.
  std::uint64_t max_segments = std::uint64_t{1} << 28;
  /// Crossings that are found, in a sum, and in each boolean operation and use of a fill rule.
  std::uint64_t max_crossings = std::uint64_t{1} << 28;
};

/// Says what an operation is doing. The first seven are the stages of a sum, in their order.
enum class Stage {
  kOperands,     ///< operands are read, validated and put on their common grid
  kConvolution,  ///< the segments of the reduced convolution are listed
  kCover,        ///< cells that are certainly inside the sum are found
  kArrangement,  ///< the segments outside the cover are intersected
  kLoops,        ///< orientable loops are extracted
  kFilters,      ///< false loops are rejected
  kOutput,       ///< the result is written
  kOverlay,      ///< fill rules, boolean operations and winding numbers are computed
  kRounding,     ///< exact numbers become doubles or decimals
  kChecking,     ///< a result is verified
  kSearch,       ///< paths, distances and contacts are searched for
};
/// The number of stages that belong to a sum.
inline constexpr int kSumStages = 7;
/// Returns the stage's name: "operands", "convolution", and so on; or "unknown".
[[nodiscard]] MINKSUM_API const char* to_string(Stage stage);

/// Tells how far an operation is.
struct Progress {
  Stage stage = Stage::kOperands;  ///< what the operation is doing
  /// Parts that are done: rows of a table, or slices of a configuration space. Every other
  /// operation is one part.
  std::size_t done = 0;
  std::size_t parts = 1;  ///< how many parts there are
};

/// What a caller decides about any operation. The defaults suit most callers, and none of these
/// changes the exact result but `fill`, `regularize` and `tight`.
struct Options {
  Limits limits = {};                      ///< limits on each sum that is computed
  std::optional<CancelToken> cancel = {};  ///< stops the operation
  /// Called when a stage begins and every few milliseconds. Returning false stops the operation as
  /// `cancel` does. Threads that share parts may call it at the same time. A single sum calls it on
  /// the calling thread alone. What it throws ends the operation and is passed on.
  std::function<bool(const Progress&)> progress = {};
  /// How many threads an operation may use, the calling one included; 0 or less = one for each
  /// core. The result does not depend on it. Tables of no-fit polygons and slices of configuration
  /// spaces share their parts, each of which takes one thread. Every other operation shares the
  /// work of its sums, from the first step on that takes over some 0.6 ms. Threads end with the
  /// call.
  int threads = 1;
  FillRule fill = FillRule::kAutomatic;  ///< which points the operands' rings enclose
  /// Whether the operands' thin parts are dropped: polylines, points, and parts of rings without
  /// area. Operations that only use areas always drop them.
  bool regularize = false;
  /// Whether the result keeps its tight places: points and polylines at which a moving set fits
  /// without play. If this is not set, only no-fit and inner-fit polygons keep them. The tight
  /// places of a sum are not part of the sum: `detailed_sum` returns them, and `minkowski_sum` does
  /// not look at this member.
  std::optional<bool> tight = {};
  /// Memory that is kept from call to call. One thread at a time may use it. If it is null, each
  /// call allocates its own.
  Workspace* memory = nullptr;
};

}  // namespace minksum

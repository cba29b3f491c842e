// What a caller decides about an operation: the same type for all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/export.h"

namespace minksum {

class Workspace;

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

/// Limits whose excess is an Error(kLimitExceeded), not a crash. All methods but the signed one
/// take no more than 2^30 of either, whatever is set.
struct Limits {
  /// Convolution segments that are listed: all of them, or, if there are very many, those that may
  /// touch an uncovered cell. Segments that are only counted are not limited.
  std::uint64_t max_segments = std::uint64_t{1} << 28;
  std::uint64_t max_crossings = std::uint64_t{1} << 28;  ///< crossings found
};

/// What an operation is doing. The first seven are the stages of a sum, in order.
enum class Stage {
  kOperands,     ///< operands are read, validated and put on their common grid
  kConvolution,  ///< the segments of the reduced convolution are listed
  kCover,        ///< cells that are certainly inside the sum are found
  kArrangement,  ///< the segments outside the cover are intersected
  kLoops,        ///< orientable loops are extracted
  kFilters,      ///< false loops are rejected
  kOutput,       ///< the result is written
  kOverlay,      ///< fill rules and boolean operations
  kRounding,     ///< exact numbers become doubles or decimals
  kChecking,     ///< a result is verified
  kSearch,       ///< paths, distances and contacts are searched
};
/// How many of the stages belong to a sum.
inline constexpr int kSumStages = 7;
/// "operands", "convolution", ...
[[nodiscard]] MINKSUM_API const char* to_string(Stage stage);

/// How far an operation is.
struct Progress {
  Stage stage = Stage::kOperands;  ///< what is being done
  /// Parts that are done: rows of a table, slices of a configuration space. Operations that have no
  /// parts are one part.
  std::size_t done = 0;
  std::size_t parts = 1;  ///< how many parts there are
};

/// What a caller decides about any operation. The defaults suit most callers.
struct Options {
  Limits limits = {};                      ///< of each sum that is computed
  std::optional<CancelToken> cancel = {};  ///< stops the operation
  /// Called when a stage begins and every few milliseconds; returning false stops the operation
  /// as `cancel` does. Several threads may call it at a time where an operation has several. What
  /// it throws ends the operation and is thrown on.
  std::function<bool(const Progress&)> progress = {};
  /// How many threads an operation on many parts may use: tables of no-fit polygons and slices of
  /// configuration spaces. 0 = one for each core.
  int threads = 1;
  FillRule fill = FillRule::kAutomatic;  ///< how operands are read
  /// Whether the operands' thin parts are dropped: polylines, points, and what rings enclose
  /// without area. Operations that only look at areas drop them in any case.
  bool regularize = false;
  /// Whether the result keeps its tight places: points and polylines that a moving set reaches
  /// without play. Without a value no-fit and inner-fit polygons keep them, and nothing else does.
  std::optional<bool> tight = {};
  /// Memory that is kept from call to call; one thread at a time may use it. Null: memory is
  /// allocated in each call.
  Workspace* memory = nullptr;
};

}  // namespace minksum

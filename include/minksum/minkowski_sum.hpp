// Declares the Minkowski sum, the call on which everything else is built.
#pragma once

#include <cstdint>
#include <memory>

#include "minksum/error.hpp"
#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"
#include "minksum/region.hpp"
#include "minksum/trace.hpp"

namespace minksum {

/// Says which number type decides what the floating-point filter cannot tell. Types are named by
/// the coordinates that they hold on the integer grid of both operands.
enum class Arithmetic {
  kAutomatic,  ///< the narrowest type that holds the operands
  kNarrow,     ///< coordinates of up to 30 bits
  kMedium,     ///< coordinates of up to 61 bits
  kWide,       ///< coordinates of up to 125 bits
  kArbitrary,  ///< rationals of any size
};

/// Tells what the computation of a sum did. Times are in seconds. Method::kSigned tells only times,
/// segments and crossings.
struct Statistics {
  /// Whether the sum was small: walks, or a merge of two convex rings, found its boundary. There
  /// were no stages then, and the counts of crossings, loops, cells and decisions are 0.
  bool small = false;
  std::uint64_t convolution_segments = 0;   ///< segments of the convolution that the method uses
  /// Segments of which the arrangement is made: those that touch an uncovered cell, without those
  /// that are seen to equal another one. Where several segments on one line were joined, both the
  /// line and these segments count.
  std::uint64_t segments_kept = 0;
  std::uint64_t crossings = 0;              ///< crossings found among the kept segments
  std::uint64_t loops = 0;                  ///< orientable loops, before any filter
  std::uint64_t rejected_by_nesting = 0;    ///< loops that the nesting filter dropped
  std::uint64_t rejected_by_collision = 0;  ///< loops that the collision filter dropped
  std::uint64_t grid_cells = 0;             ///< cells of the cover's grid; 0 = there is no cover
  std::uint64_t covered_cells = 0;          ///< cells that certainly lie inside the sum

  std::uint64_t coordinate_bits = 0;        ///< bits of coordinates on the operands' common grid
  Arithmetic arithmetic = Arithmetic::kAutomatic;  ///< the rung that was used
  std::uint64_t by_filter = 0;              ///< decisions by the floating-point filter
  std::uint64_t by_fixed_width = 0;         ///< decisions by integers of fixed width
  std::uint64_t by_arbitrary = 0;           ///< decisions by numbers of any size

  double seconds = 0;                       ///< time of the whole call
  /// Time of each Stage. Without stages, only kOperands has some, if an operand had to be prepared.
  double stage_seconds[kSumStages] = {};
};

/// Keeps memory from call to call, so that later sums allocate less. One thread at a time may use a
/// workspace. After a call that failed, it works as before.
class MINKSUM_API Workspace {
 public:
  Workspace();
  ~Workspace();
  /// Takes over the memory. The other workspace may be used on, and begins without memory.
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;  ///< takes over the memory in the same way
  struct State;
  [[nodiscard]] State& state();

 private:
  std::unique_ptr<State> state_;
};

/// Returns P ⊕ Q = { p + q | p ∈ P, q ∈ Q }, exactly.
///
/// P and Q are valid regions (see `validate`): polygons with holes, in one part or in several. An
/// empty operand gives an empty sum. The result is valid and canonical (see Region), and has an
/// origin for each edge. Many threads may call this at once.
///
/// Let the operands have n and m vertices, the reduced convolution k listed segments (see Limits),
/// and let c crossings lie outside the cover. Then the time is O((n + m) log (n + m) + k + c log
/// c), and the memory O(n + m + k + c).
///
/// Throws Error: kBadInput for an operand that is not valid, whose culprit has operand, polygon,
/// ring and vertex; kLimitExceeded (see Limits); kCancelled; kInternal.
///
/// Paper: E. Behar, J.-M. Lien, "Fast and Robust 2D Minkowski Sum Using Reduced Convolution", IROS
/// 2011, section IV. docs/pipeline.md says where this library differs.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const Region& p, const Region& q,
                                               const Options& options = {});

/// Computes the same into `result`, reuses its memory and that of `workspace`, and returns errors
/// instead of throwing them. What a callback throws passes. On failure `result` is empty.
/// `result` may be an operand, which is lost then.
MINKSUM_API Outcome minkowski_sum(const Region& p, const Region& q, const Options& options,
                                  Workspace& workspace, Region& result);

/// Returns the sum of any two geometries: rings of any kind, read by `options.fill`, polylines and
/// points. The result is P ⊕ Q, resolved (see Geometry) and closed. It has thin parts only where
/// both operands are thin. It has origins only if both operands are valid and have no thin parts.
/// Throws as above. A ring that is not valid is an error only by FillRule::kStrict.
[[nodiscard]] MINKSUM_API Geometry minkowski_sum(const Geometry& p, const Geometry& q,
                                                 const Options& options = {});
/// Computes the same into `result` with memory that is reused, and returns errors, as above.
MINKSUM_API Outcome minkowski_sum(const Geometry& p, const Geometry& q, const Options& options,
                                  Workspace& workspace, Geometry& result);

/// A sum, and what else its computation tells.
struct DetailedSum {
  Geometry sum;  ///< as minkowski_sum returns it; the sum of regions is `sum.region`
  /// The tight places, if `Options::tight` asks for them: points and polylines, resolved (see
  /// Geometry). They are the closure of the points in the interior of P ⊕ Q that are not in
  /// P° ⊕ Q°. There P and x − Q touch and have no play, or have play along a path only. Only the
  /// operands' areas count as P and Q here. Places that a sum with a thin operand covers are left
  /// out.
  Geometry tight;
  Statistics statistics;  ///< what the computation of the sum of both areas did
  Trace trace;            ///< what its stages made, if Detail::kTrace asks for it
};

/// Says what a DetailedSum has besides the sum, the tight places and the statistics.
enum class Detail {
  kStatistics,  ///< nothing more
  kTrace,       ///< the trace of the sum of both areas; small operands take the stages, too
};

/// Returns P ⊕ Q with statistics, and with tight places and a trace if these are asked for. The
/// computation takes the same steps as minkowski_sum, but small operands take the stages if tight
/// places or a trace are asked for. Regions must be valid. Complexity and errors are those of
/// minkowski_sum.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Region& p, const Region& q,
                                                   const Options& options = {},
                                                   Detail detail = Detail::kStatistics);
/// Returns the same for any two geometries, which are read by `options.fill`.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Geometry& p, const Geometry& q,
                                                   const Options& options = {},
                                                   Detail detail = Detail::kStatistics);

}  // namespace minksum

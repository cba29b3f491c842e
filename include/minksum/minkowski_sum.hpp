// The Minkowski sum of two regions: the one call that everything else is built on.
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

/// Which number type exact decisions use once the floating-point filter has passed.
enum class Arithmetic {
  kAutomatic,  ///< the narrowest that holds the operands
  kNarrow,     ///< coordinates up to 30 bits
  kMedium,     ///< up to 61 bits
  kWide,       ///< up to 125 bits
  kArbitrary,  ///< rationals of any size
};

/// What the computation of a sum did.
struct Statistics {
  /// Whether operands were so small that one walk found the sum's boundary. Then there were no
  /// stages: crossings, loops, cells and decisions are not counted, but are 0.
  bool small = false;
  std::uint64_t convolution_segments = 0;   ///< segments of the (reduced, signed, full) convolution
  /// What the arrangement is made of: segments that touch an uncovered cell, but for such as are
  /// seen to equal another; where several on one line were joined, the line and those
  /// that it takes.
  std::uint64_t segments_kept = 0;
  std::uint64_t crossings = 0;              ///< crossings found among the kept ones
  std::uint64_t loops = 0;                  ///< orientable loops
  std::uint64_t rejected_by_nesting = 0;    ///< loops that the nesting filter dropped
  std::uint64_t rejected_by_collision = 0;  ///< loops that the collision filter dropped
  std::uint64_t grid_cells = 0;             ///< cells of the cover's grid; 0 = no cover
  std::uint64_t covered_cells = 0;          ///< cells that certainly lie inside the sum

  std::uint64_t coordinate_bits = 0;        ///< of both operands on their common integer grid
  Arithmetic arithmetic = Arithmetic::kAutomatic;  ///< the rung that was used
  std::uint64_t by_filter = 0;              ///< decisions that the floating-point filter took
  std::uint64_t by_fixed_width = 0;         ///< decisions by integers of fixed width
  std::uint64_t by_arbitrary = 0;           ///< decisions by numbers of any size

  double seconds = 0;                       ///< the whole call
  double stage_seconds[kSumStages] = {};    ///< indexed by Stage; 0 for sums without stages
};

/// Memory that is kept from call to call. One thread at a time may use a workspace.
class MINKSUM_API Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;
  struct State;
  [[nodiscard]] State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

/// P ⊕ Q = { p + q | p ∈ P, q ∈ Q }, exactly.
///
/// P and Q are valid polygons with holes or multipolygons (see `validate`); an empty operand gives
/// an empty sum. The result is a valid, canonical region (see Region) with an origin for each edge.
/// Safe to call from many threads at once. Time O((n + m) log (n + m) + k + c log c), memory
/// O(n + m + k + c), for operands of n and m vertices, k listed segments of the reduced convolution
/// (see Limits) and c crossings outside the cover.
/// Throws Error: kBadInput (names ring and vertex), kLimitExceeded, kCancelled, kInternal.
/// Paper: E. Behar, J.-M. Lien, "Fast and Robust 2D Minkowski Sum Using Reduced Convolution",
/// IROS 2011, section IV; docs/pipeline.md says where we differ.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const Region& p, const Region& q,
                                               const Options& options = {});

/// The same into a result that is reused, with memory that is reused, and no exception for bad
/// input, limits or cancellation. On failure `result` is empty.
MINKSUM_API Outcome minkowski_sum(const Region& p, const Region& q, const Options& options,
                                  Workspace& workspace, Region& result);

/// The sum of any two geometries: rings of any kind, read by `options.fill`, polylines and points.
/// It is the set P ⊕ Q, resolved (see Geometry): closed, with thin parts where both operands are
/// thin. Throws as above.
[[nodiscard]] MINKSUM_API Geometry minkowski_sum(const Geometry& p, const Geometry& q,
                                                 const Options& options = {});
/// The same with memory that is reused, and no exception; as above.
MINKSUM_API Outcome minkowski_sum(const Geometry& p, const Geometry& q, const Options& options,
                                  Workspace& workspace, Geometry& result);

/// A sum, and what else its computation tells.
struct DetailedSum {
  Geometry sum;  ///< as minkowski_sum returns it; for regions, `sum.region`
  /// The tight places, if `Options::tight` asks for them: the closure of the points that P ⊕ Q has
  /// in its interior and P° ⊕ Q° has not. There P and x − Q touch and have no play, or play along a
  /// path only: single points, and polylines. Resolved (see Geometry), without area. They are those
  /// of both areas, less what the sum's thin operands cover.
  Geometry tight;
  Statistics statistics;  ///< of the sum of both areas
  Trace trace;            ///< if it was asked for
};

/// What a DetailedSum has beside sum, tight places and statistics.
enum class Detail {
  kStatistics,  ///< nothing more
  kTrace,       ///< the trace of the sum of both areas, by the stages even where these are small
};

/// P ⊕ Q as by minkowski_sum, which takes the same steps, and what is known of it. Regions must be
/// valid. Throws as above.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Region& p, const Region& q,
                                                   const Options& options = {},
                                                   Detail detail = Detail::kStatistics);
/// The same for any two geometries, read by `options.fill`.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const Geometry& p, const Geometry& q,
                                                   const Options& options = {},
                                                   Detail detail = Detail::kStatistics);

}  // namespace minksum

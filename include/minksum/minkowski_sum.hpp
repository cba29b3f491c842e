// The Minkowski sum of two regions: the one call that everything else is built on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/error.hpp"
#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/region.hpp"
#include "minksum/resolve.hpp"
#include "minksum/trace.hpp"

namespace minksum {

/// How the sum is computed. All three give the same region.
enum class Method {
  /// Reduced convolution, cover, orientable loops (Behar and Lien, IROS 2011). The fast one.
  kReduced,
  /// Signed convolution and winding numbers (Guibas, Ramshaw, Stolfi 1983), on code of its own:
  /// an independent check. Meant for small and middling operands.
  kSigned,
  /// The full convolution of Wein (ESA 2006), reflex vertices included, no cover. Slow; for the
  /// comparisons of the paper.
  kFull,
};

/// Which number type exact decisions use once the floating-point filter has passed.
enum class Arithmetic {
  kAutomatic,  ///< the narrowest that holds the operands
  kNarrow,     ///< coordinates up to 30 bits
  kMedium,     ///< up to 61 bits
  kWide,       ///< up to 125 bits
  kArbitrary,  ///< rationals of any size
};

/// The stages of the pipeline, in order.
enum class Stage { kOperands, kConvolution, kCover, kArrangement, kLoops, kFilters, kOutput };
inline constexpr int kStageCount = 7;
/// "operands", "convolution", ...
[[nodiscard]] MINKSUM_API const char* to_string(Stage stage);

/// Limits whose excess is an Error(kLimitExceeded), not a crash. All methods but kSigned take no
/// more than 2^30 of either, whatever is set.
struct Limits {
  /// Convolution segments that are listed: all, or of very many those that may touch an uncovered
  /// cell. Those that are only counted are not limited.
  std::uint64_t max_segments = std::uint64_t{1} << 28;
  std::uint64_t max_crossings = std::uint64_t{1} << 28;  ///< crossings found
};

/// What a computation did.
struct Statistics {
  std::uint64_t convolution_segments = 0;   ///< segments of the (reduced, signed, full) convolution
  /// What the arrangement is made of: segments that touch an uncovered cell, but for such as are
  /// seen to equal another; where several on one line were joined, the line and those
  /// that it takes.
  std::uint64_t segments_kept = 0;
  std::uint64_t crossings = 0;              ///< crossings found among the kept ones
  std::uint64_t loops = 0;                  ///< orientable loops
  std::uint64_t rejected_by_nesting = 0;
  std::uint64_t rejected_by_collision = 0;
  std::uint64_t grid_cells = 0;             ///< cells of the cover's grid; 0 = no cover
  std::uint64_t covered_cells = 0;

  std::uint64_t coordinate_bits = 0;        ///< of both operands on their common integer grid
  Arithmetic arithmetic = Arithmetic::kAutomatic;  ///< the rung that was used
  std::uint64_t by_filter = 0;              ///< decisions that the floating-point filter took
  std::uint64_t by_fixed_width = 0;
  std::uint64_t by_arbitrary = 0;

  double seconds = 0;                       ///< the whole call
  double stage_seconds[kStageCount] = {};   ///< indexed by Stage
};

/// Everything that can be asked of minkowski_sum beyond its operands.
struct Options {
  Method method = Method::kReduced;
  Arithmetic arithmetic = Arithmetic::kAutomatic;
  bool filter = true;             ///< false: every decision by exact arithmetic (for tests)
  bool cover = true;              ///< false: no cover; the whole arrangement is built
  int grid = 0;                   ///< cells along the longer side of the cover's grid; 0 = chosen
  bool check = false;             ///< run each stage's checker on its result (for tests; slow)
  Limits limits = {};
  std::optional<CancelToken> cancel = {};
  /// Called at the start of each stage and now and then within; return false to stop.
  std::function<bool(Stage)> progress = {};
  Statistics* statistics = nullptr;  ///< filled if given
  Trace* trace = nullptr;            ///< filled if given (Method::kReduced and kFull)

  /// The tight places: closure of the points that P ⊕ Q has in its interior and P° ⊕ Q° has not.
  /// There P and x − Q touch and have no play, or play along a path only: single points, and
  /// polylines. Resolved (see Geometry), without area; filled if given (Method::kReduced).
  Geometry* tight = nullptr;

  FillRule fill = FillRule::kAutomatic;  ///< how operands given as geometries are read
  bool regularize = false;               ///< whether their thin parts are dropped
};

/// How a call without exceptions ended. `error` is there unless it went well.
struct [[nodiscard]] Outcome {
  std::optional<Error> error;
  [[nodiscard]] bool ok() const { return !error.has_value(); }
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
/// thin. Statistics are those of the sum of both areas. Tight places are those of both areas, less
/// what the sum's thin operands cover. Throws as above.
[[nodiscard]] MINKSUM_API Geometry minkowski_sum(const Geometry& p, const Geometry& q,
                                                 const Options& options = {});
/// The same with memory that is reused, and no exception; as above.
MINKSUM_API Outcome minkowski_sum(const Geometry& p, const Geometry& q, const Options& options,
                                  Workspace& workspace, Geometry& result);

}  // namespace minksum

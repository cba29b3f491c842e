// An operand made ready once, to be summed with many others.
#pragma once

#include <memory>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// A valid operand with all that is independent of the other one done: validated, cleaned, on its
/// integer grid, its edge directions sorted.
///
/// Worth its while where one shape meets several others: nesting parts, a robot among obstacles.
/// Immutable: any number of threads may use one at the same time. Copies share one state.
class MINKSUM_API PreparedRegion {
 public:
  /// Throws Error(kBadInput) naming polygon, ring and vertex if `region` is no valid operand (see
  /// `validate`), Error(kLimitExceeded) as `validate` does, and Error(kCancelled). An empty region
  /// is valid. O(n log n) for n vertices, plus close pairs of edges.
  explicit PreparedRegion(Region region, const Options& options = {});

  /// The operand as it was given.
  [[nodiscard]] const Region& region() const;

  struct State;
  [[nodiscard]] const State& state() const { return *state_; }

 private:
  std::shared_ptr<const State> state_;
};

/// P ⊕ Q, the same region as from the operands themselves. The operands' stage is down to copying
/// and merging sorted lists, O(n + m); the rest is as for `minkowski_sum` of regions.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                               const Options& options = {});

/// The same with an operand that is not prepared.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const Region& p, const PreparedRegion& q,
                                               const Options& options = {});
/// The same with an operand that is not prepared.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const PreparedRegion& p, const Region& q,
                                               const Options& options = {});

/// The same, and what is known of the sum.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const PreparedRegion& p, const PreparedRegion& q,
                                                   const Options& options = {},
                                                   Detail detail = Detail::kStatistics);

/// The same into a result that is reused, with memory that is reused, and no exception for limits
/// or cancellation. On failure `result` is empty.
MINKSUM_API Outcome minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                  const Options& options, Workspace& workspace, Region& result);
/// The same with an operand that is not prepared.
MINKSUM_API Outcome minkowski_sum(const Region& p, const PreparedRegion& q, const Options& options,
                                  Workspace& workspace, Region& result);
/// The same with an operand that is not prepared.
MINKSUM_API Outcome minkowski_sum(const PreparedRegion& p, const Region& q, const Options& options,
                                  Workspace& workspace, Region& result);

}  // namespace minksum

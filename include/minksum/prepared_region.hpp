// Declares an operand that is made ready once and then added to many others.
#pragma once

#include <memory>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// A valid operand for which everything that does not depend on the other operand is done: it is
/// validated, cleaned and put on its integer grid, and its edge directions are sorted.
///
/// Preparing pays where one shape meets several others: nesting parts, or a robot among obstacles.
/// Any number of threads may use one at the same time, as it never changes. Copies share one state.
class MINKSUM_API PreparedRegion {
 public:
  /// Prepares a region. An empty region is valid. O(n log n) for n vertices. Throws Error:
  /// kBadInput if `region` is not valid (see `validate`), whose culprit has polygon, ring and
  /// vertex, but no operand; kLimitExceeded as `validate` does; kCancelled.
  explicit PreparedRegion(Region region, const Options& options = {});
  /// Copies share the state, and so does an object with what was moved from it.
  PreparedRegion(const PreparedRegion&) = default;
  PreparedRegion& operator=(const PreparedRegion&) = default;
  ~PreparedRegion() = default;

  /// Returns the operand as it was given.
  [[nodiscard]] const Region& region() const&;
  /// Returns the operand of an object that ends with the expression.
  [[nodiscard]] Region region() && { return static_cast<const PreparedRegion&>(*this).region(); }

  struct State;
  [[nodiscard]] const State& state() const { return *state_; }

 private:
  std::shared_ptr<const State> state_;
};

/// Returns P ⊕ Q, the same region as from the operands themselves. The stage of the operands takes
/// O(n + m): it only copies and merges sorted lists. The rest is as in `minkowski_sum` of regions.
/// Throws Error: kLimitExceeded, kCancelled, kInternal.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                               const Options& options = {});

/// Returns the same with an operand that is not prepared. Throws as for two regions.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const Region& p, const PreparedRegion& q,
                                               const Options& options = {});
/// Returns the same with an operand that is not prepared. Throws as for two regions.
[[nodiscard]] MINKSUM_API Region minkowski_sum(const PreparedRegion& p, const Region& q,
                                               const Options& options = {});

/// Returns the same with statistics, tight places and trace, as `detailed_sum` of regions does.
[[nodiscard]] MINKSUM_API DetailedSum detailed_sum(const PreparedRegion& p, const PreparedRegion& q,
                                                   const Options& options = {},
                                                   Detail detail = Detail::kStatistics);

/// Computes the same into `result`, reuses its memory and that of `workspace`, and returns errors
/// instead of throwing them. On failure `result` is empty.
MINKSUM_API Outcome minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                  const Options& options, Workspace& workspace, Region& result);
/// Computes the same with an operand that is not prepared.
MINKSUM_API Outcome minkowski_sum(const Region& p, const PreparedRegion& q, const Options& options,
                                  Workspace& workspace, Region& result);
/// Computes the same with an operand that is not prepared.
MINKSUM_API Outcome minkowski_sum(const PreparedRegion& p, const Region& q, const Options& options,
                                  Workspace& workspace, Region& result);

}  // namespace minksum

// The sum of two operands of few vertices, by one walk along its outer boundary.
#pragma once

#include <memory>

#include "minksum/minkowski_sum.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// Memory that is kept from sum to sum; it is taken when it is needed first.
class SmallScratch {
 public:
  SmallScratch();
  ~SmallScratch();
  SmallScratch(SmallScratch&&) noexcept;
  SmallScratch& operator=(SmallScratch&&) noexcept;
  struct State;
  [[nodiscard]] State& state();

 private:
  std::unique_ptr<State> state_;
};

/// P ⊕ Q, in canonical form, with origins: the same region as by the stages. False if it takes
/// them: if the sum may have a hole or an operand may fit into one of the other's, or there are
/// more segments than are worth it, or too long coordinates; `result` is then as it was.
///
/// The reduced convolution is listed; the walk starts at the smallest point and turns into the
/// first segment on its right, again and again. It is all of the sum's boundary if fewer than three
/// corners are left where one segment could turn right into another: a hole has three of them. See
/// docs/pipeline.md, "Small operands". O(s²) for s segments, eight at a time. Of convex operands
/// edges are merged in the order of their directions.
bool sum_small(const SmallOperand& p, const SmallOperand& q, SmallScratch& scratch, Region& result);

/// Whether no sum of small operands could go beyond these limits.
[[nodiscard]] bool allow_small(const Limits& limits);

}  // namespace minksum

// Computes the sum of two operands of few vertices by one walk along its outer boundary.
#pragma once

#include <array>
#include <memory>

#include "minksum/minkowski_sum.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// Memory that is kept from sum to sum. It is allocated at first use.
class SmallScratch {
 public:
  SmallScratch();
  ~SmallScratch();
  SmallScratch(SmallScratch&&) noexcept;
  SmallScratch& operator=(SmallScratch&&) noexcept;
  struct State;
  [[nodiscard]] State& state();
  /// For operands that are not prepared.
  [[nodiscard]] std::array<SmallOperand, 2>& operands() { return operands_; }
  [[nodiscard]] SmallHoles& holes() { return holes_; }
  /// Of the last sum's reduced convolution.
  [[nodiscard]] std::uint64_t segments() const { return segments_; }
  void count(std::uint64_t segments) { segments_ = segments; }

 private:
  std::unique_ptr<State> state_;
  std::array<SmallOperand, 2> operands_;
  SmallHoles holes_;
  std::uint64_t segments_ = 0;
};

/// Computes P ⊕ Q in canonical form, with origins: the same region as by the stages. Returns false
/// if the stages are needed, and leaves `result` as it was. The stages are needed if the sum may
/// have a hole, or if an operand may fit into a hole of the other. They are also needed if there
/// are more segments than pay, or if coordinates are too long.
///
/// The reduced convolution is listed. The walk starts at the smallest point and turns into the
/// first segment on its right, again and again. It is all of the sum's boundary if fewer than three
/// corners are left where one segment could turn right into another: a hole has three of them. See
/// docs/pipeline.md, "How is a small sum computed?". O(s²) for s segments, eight at a time. The
/// edges of two convex operands are merged in order of direction instead.
bool sum_small(const SmallOperand& p, const SmallOperand& q, SmallScratch& scratch, Region& result);

/// Brings two operands to their common grid. Those that must change are copied to `memory`, if they
/// are not there already. Returns false if that grid is too fine for one.
bool bring_to_one_grid(std::array<const SmallOperand*, 2>& operands,
                       std::array<SmallOperand, 2>& memory);

/// Returns the number type for a sum of two operands on their common grid, or kNone if `sum_small`
/// would return false before it does any work. The operands need not be known to be valid.
[[nodiscard]] SmallNumberType numbers_of_sum(const SmallOperand& p, const SmallOperand& q);

/// Whether no sum of small operands could go beyond these limits.
[[nodiscard]] bool allow_small(const Limits& limits);

}  // namespace minksum

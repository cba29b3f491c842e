// Computes the sum of two operands of not too many vertices by walks along its boundary.
#pragma once

#include <array>
#include <memory>

#include "minksum/minkowski_sum.hpp"
#include "sum/small/blocks.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// Memory that is kept from sum to sum. It is allocated at first use.
class SmallScratch {
 public:
  SmallScratch();
  ~SmallScratch();
  SmallScratch(const SmallScratch&) = delete;
  SmallScratch& operator=(const SmallScratch&) = delete;
  struct State;
  [[nodiscard]] State& state();
  /// For operands that are not prepared.
  [[nodiscard]] std::array<SmallOperand, 2>& operands() { return operands_; }
  /// For `is_clearly_valid`.
  [[nodiscard]] SmallBlocks& blocks() { return blocks_; }
  /// Of the last sum's reduced convolution: all segments, and those that a cover leaves.
  [[nodiscard]] std::uint64_t segments() const { return segments_; }
  [[nodiscard]] std::uint64_t segments_kept() const { return segments_kept_; }
  void set_counts(std::uint64_t segments, std::uint64_t kept) {
    segments_ = segments;
    segments_kept_ = kept;
  }

 private:
  std::unique_ptr<State> state_;
  std::array<SmallOperand, 2> operands_;
  SmallBlocks blocks_;
  std::uint64_t segments_ = 0;
  std::uint64_t segments_kept_ = 0;
};

/// Computes P ⊕ Q in canonical form, with origins: the same region as by the stages. Returns false
/// if the stages are needed (docs/pipeline.md lists when); then `result` has no meaning.
///
/// The reduced convolution is listed. The walk starts at the smallest point and turns into the
/// first segment on its right, again and again. Some right turns are not taken. A hole has at least
/// three of these, and a walk by the same rule goes round it. If an operand has several polygons,
/// walks start at the smallest points of all their sums. See docs/pipeline.md, "How is a small
/// sum computed?". Comparing each vertex with each edge and finding near blocks takes O(m·n + s²)
/// for s segments, with small constants, as long as that takes less than the stages. The edges of
/// two convex operands are merged in order of direction instead, in O(m + n).
bool sum_small(const SmallOperand& p, const SmallOperand& q, SmallScratch& scratch, Region& result);

/// How a sum of two operands is computed.
struct SmallPlan {
  SmallNumberType numbers = SmallNumberType::kNone;  ///< on their common grid
  /// By operand, whether its holes stay. Otherwise they are filled: the other one fits into none.
  std::array<bool, 2> with_holes{};
  bool convex = false;  ///< whether both are, apart from holes that are filled
  double segments = 0;  ///< about how many there will be, unless both are
  int exp2 = 0;         ///< a step of the common grid: 2^exp2 · 10^exp10
  int exp10 = 0;
};
/// Plans a sum. O(1 + number of holes). If the numbers are kNone, the stages are
/// needed. The operands need not be known to be valid.
[[nodiscard]] SmallPlan plan_sum(const SmallOperand& p, const SmallOperand& q);

/// Brings two operands to their common grid. Those that must change are copied to `memory`, if they
/// are not there already.
void bring_to_one_grid(const SmallPlan& plan, std::array<const SmallOperand*, 2>& operands,
                       std::array<SmallOperand, 2>& memory);

/// The same as above, of operands that have been brought to their common grid.
bool sum_small(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
               SmallScratch& scratch, Region& result);

/// Whether no sum of small operands could go beyond these limits.
[[nodiscard]] bool allow_small(const Limits& limits);

}  // namespace minksum

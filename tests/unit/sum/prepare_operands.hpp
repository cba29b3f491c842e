// Runs the first stage for two regions, for tests of later stages.
#pragma once

#include <gtest/gtest.h>

#include "sum/operands/operands.hpp"

namespace minksum::test {

inline void prepare_operands(const Region& p, const Region& q, const SumSettings& options,
                             Operands& operands) {
  Cancellation never;
  OperandScratch scratch;
  std::array<PreparedOperand, 2> prepared;
  std::vector<Fault> faults;
  prepare_operand(p, options, 1, never, scratch, prepared[0], faults);
  prepare_operand(q, options, 1, never, scratch, prepared[1], faults);
  ASSERT_TRUE(faults.empty());
  combine_operands(prepared[0], prepared[1], options, NarrowHoles::kFill, never, operands);
}

}  // namespace minksum::test

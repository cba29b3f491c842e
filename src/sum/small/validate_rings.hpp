// Tells whether the rings of a small operand are clearly valid, by numbers of any type.
#pragma once

#include "machine/vectors.hpp"
#include "sum/small/small_operand.hpp"
#include "sum/small/small_rings.hpp"

namespace minksum {

template <class Number>
bool are_rings_valid(const SmallNumbers<Number>& numbers, const SmallOperand& s,
                     SmallBlocks& memory) {
  const SmallEdges edges(s, s.entries, numbers.reach, memory);
  const auto are_valid = [&]() __attribute__((always_inline)) {
    return are_apart(numbers, edges, s) && are_holes_inside(numbers, edges, s);
  };
  return with_vectors(widest_vectors(), are_valid);
}

}  // namespace minksum

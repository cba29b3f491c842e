// Tells whether a small operand is clearly valid.
#include <algorithm>

#include "machine/vectors.hpp"
#include "sum/small/small_operand.hpp"
#include "sum/small/small_rings.hpp"

namespace minksum {

bool is_clearly_valid(const SmallOperand& s, SmallBlocks& memory) {
  // A ring that turns left everywhere, and goes round once, is simple. Rounded edges may make it
  // seem to go round more often, but not less.
  if (s.ends.empty() && s.convex && s.turning == 1) return true;
  const double width = std::max(s.extent.x, s.extent.y);
  const auto is_valid = [&](const auto& numbers) {
    const SmallEdges edges(s, s.entries, numbers.reach, memory);
    const SmallRings rings(s);
    const auto are_valid = [&]() __attribute__((always_inline)) {
      return are_apart(numbers, edges, rings) && are_holes_inside(numbers, edges, rings);
    };
    return with_vectors(widest_vectors(), are_valid);
  };
  return with_numbers<Int128>(small_numbers(s.is_wide(), s.longest, width), width, is_valid);
}

bool read_small(const Region& region, SmallOperand& small) {
  SmallBlocks memory;
  return load_small(region, small) && is_clearly_valid(small, memory);
}

}  // namespace minksum

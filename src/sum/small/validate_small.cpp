// Tells whether a small operand is clearly valid.
#include <algorithm>

#include "sum/small/validate_rings.hpp"

namespace minksum {

bool is_clearly_valid(const SmallOperand& s, SmallBlocks& memory) {
  // A ring that turns left everywhere, and goes round once, is simple. Rounded edges may make it
  // seem to go round more often, but not less.
  if (s.ends.size() == 1 && s.convex && s.turning == 1) return true;
  if (s.has_several()) return false;
  if (s.is_long()) return is_long_valid(s, memory);
  const double width = std::max(s.extent.x, s.extent.y);
  return with_numbers<Int128>(
      small_numbers(s.is_wide(), s.longest, width), width,
      [&](const auto& numbers) { return are_rings_valid(numbers, s, memory); });
}

bool read_small(const Region& region, SmallOperand& small) {
  SmallBlocks memory;
  return load_small(region, small) && is_clearly_valid(small, memory);
}

}  // namespace minksum

// What operands need whose integers have more than 125 bits: loading, validation, exact vectors,
// copies and turns.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sum/small/load_rings.hpp"
#include "sum/small/validate_rings.hpp"

namespace minksum {

bool load_long(const Region& region, SmallOperand& s) { return load_rings<WideNumber>(region, s); }

Vec<WideNumber> SmallOperand::long_multiple(const Vec<WideNumber>& v) const {
  if (steps == 1) return v;
  return {product<WideNumber>(v.x, steps), product<WideNumber>(v.y, steps)};
}

Vec<WideNumber> SmallOperand::long_exact(int row, std::size_t i) const {
  if (row == kX) return long_multiple(long_[i]);
  const auto [from, to] = ends_of(row == kInX, static_cast<std::uint32_t>(i));
  return long_multiple(minus(long_[to], long_[from]));
}

void SmallOperand::copy_long(const SmallOperand& from) {
  long_extent = from.long_extent;
  long_offset = from.long_offset;
  std::copy_n(from.long_.begin(), stride_, long_.begin());
}

void SmallOperand::turn_long() {
  const auto near = [&](const WideNumber& value) {
    return to_near_double(value) * static_cast<double>(steps);
  };
  for (std::size_t i = 0; i < filled_up(entries); ++i) {
    long_[i] = {long_extent.y - long_[i].y, long_[i].x};
    (*this)[kX][i] = near(long_[i].x);
    (*this)[kY][i] = near(long_[i].y);
  }
  std::swap(long_extent.x, long_extent.y);
  long_offset = {-(long_offset.y + long_extent.x), long_offset.x};
}

double SmallOperand::long_reach() const {
  return std::max(
      {extent.x, extent.y, std::abs(to_double(long_offset.x)), std::abs(to_double(long_offset.y))});
}

bool is_long_valid(const SmallOperand& s, SmallBlocks& memory) {
  const double width = std::max(s.extent.x, s.extent.y);
  return are_rings_valid(SmallNumbers<WideNumber>{reach_of(width)}, s, memory);
}

}  // namespace minksum

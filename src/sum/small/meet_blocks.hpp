// Finds the meetings of two blocks of eight segments.
#pragma once

#include "sum/small/small_segments.hpp"

namespace minksum {

/// The meetings of two blocks. Bit 8 r + t stands for the pair of a segment r of one block and a
/// segment t of the other.
struct BlockMeetings {
  /// On the way of r, behind its start, t leads to the right of r.
  LaneBits right = 0;
  /// On the way of t, behind its start, r leads to the right of t.
  LaneBits right_of_other = 0;
  /// At the end of r, t leads to the left of r, or is on its line.
  LaneBits at_end = 0;
  LaneBits at_end_of_other = 0;
};

/// Finds the meetings of the segments `rows` of a block with those of another block.
template <class Number>
[[gnu::always_inline]] inline BlockMeetings meet_blocks(const SmallSegments& s, std::size_t block,
                                                        std::size_t other, LaneBits rows) {
  const double* const x = s.x.data() + other * kLanes;
  const double* const y = s.y.data() + other * kLanes;
  const double* const dx = s.dx.data() + other * kLanes;
  const double* const dy = s.dy.data() + other * kLanes;
  BlockMeetings meetings;
  for (; rows != 0; rows &= rows - 1) {
    const auto row = static_cast<unsigned>(std::countr_zero(rows));
    const std::size_t of = block * kLanes + row;
    const auto of_x = static_cast<Number>(s.x[of]);
    const auto of_y = static_cast<Number>(s.y[of]);
    const auto of_dx = static_cast<Number>(s.dx[of]);
    const auto of_dy = static_cast<Number>(s.dy[of]);
    LaneBits bits = 0;  // one byte for each kind
    for (std::size_t t = 0; t < kLanes; ++t) {
      const Number ax = static_cast<Number>(x[t]) - of_x;
      const Number ay = static_cast<Number>(y[t]) - of_y;
      const auto tx = static_cast<Number>(dx[t]);
      const auto ty = static_cast<Number>(dy[t]);
      // Seen from t, `along` is the start of r, -`left` is its end, and -`turn` is its turn.
      const Number start = of_dx * ay - of_dy * ax;  // how far t starts on the left of r
      const Number turn = of_dx * ty - of_dy * tx;   // and how much farther it ends there
      const Number end = start + turn;
      const Number along = ax * ty - ay * tx;  // they meet at along / turn of the way of r
      const Number left = turn - along;
      const bool right = (start >= 0) & (end < 0) & (along < 0) & (left <= 0);
      const bool right_of_other = (along >= 0) & (left > 0) & (start < 0) & (end >= 0);
      const bool at_end = (left == 0) & (start <= 0) & (end >= 0) & !((end == 0) & (start < 0));
      const bool at_end_of_other =
          (end == 0) & (along <= 0) & (left <= 0) & !((left == 0) & (along < 0));
      bits |= (right ? kBitOf[t] : 0) | (right_of_other ? kBitOf[t + kLanes] : 0) |
              (at_end ? kBitOf[t + 2 * kLanes] : 0) |
              (at_end_of_other ? kBitOf[t + 3 * kLanes] : 0);
    }
    const auto byte = [&](unsigned kind) {
      return (bits >> (kind * kLanes) & first_bits(kLanes)) << (row * kLanes);
    };
    meetings.right |= byte(0);
    meetings.right_of_other |= byte(1);
    meetings.at_end |= byte(2);
    meetings.at_end_of_other |= byte(3);
  }
  return meetings;
}

}  // namespace minksum

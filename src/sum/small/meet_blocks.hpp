// Finds the meetings of two blocks of eight segments.
#pragma once

#include "sum/small/small_segments.hpp"

namespace minksum {

/// The meetings of two blocks. Bit 8 t + r stands for the pair of a segment r of one block and a
/// segment t of the other.
struct BlockMeetings {
  /// On the way of r, behind its start, t leads to the right of r.
  LaneBits right = 0;
  /// On the way of t, behind its start, r leads to the right of t.
  LaneBits right_of_other = 0;
  /// At the end of r, t leads to the left of r, or is on its line. Of the latter, those that do not
  /// touch r may be missing.
  LaneBits at_end = 0;
  LaneBits at_end_of_other = 0;
  /// How many pairs doubles did not decide.
  std::size_t exact = 0;
};

/// Finds the meetings of the segments `rows` of a block with those of another block, as far as
/// `pairs` are concerned.
template <class Number>
[[gnu::always_inline]] inline BlockMeetings meet_blocks(const SmallNumbers<Number>& numbers,
                                                        const SmallSegments& s, std::size_t block,
                                                        std::size_t other, LaneBits rows,
                                                        LaneBits pairs) {
  const auto starts = s.at();
  const auto ways = s.way();
  if (s.in_part) {
    // Where parts are not near each other, segments meet inside the sum at most.
    LaneBits near = 0;
    for_each_bit(
        rows, [&](std::uint32_t row) __attribute__((always_inline)) {
          const BoxOf<double> box = moved(s.box_of_part(block * kLanes + row), {}, numbers.reach);
          near |= s.part.near(other, box) << (row * kLanes);
        });
    pairs &= near;
  }
  const auto kinds = [&](const auto& lanes, std::size_t row, std::size_t t)
      __attribute__((always_inline)) {
    const std::size_t of = block * kLanes + row;
    const std::size_t i = other * kLanes + t;
    if constexpr (std::is_same_v<Number, WideNumber> &&
                  !std::decay_t<decltype(lanes)>::kRoundsPoints) {
      // Doubles do not decide pairs on about one line, and most of these are apart. With the units
      // of `reach_of`, the sides of the inequality in `do_boxes_meet` are off by less than 48u, and
      // this slack is 64u.
      const double slack = 2 * numbers.reach;
      if (!do_boxes_meet(ways[of], minus(starts[i], starts[of]), ways[i], slack)) {
        return LaneBits{0};
      }
    }
    const auto a = minus(lanes.get(starts, i), lanes.get(starts, of));
    ZeroSides zeros;
    if constexpr (std::is_same_v<Number, WideNumber>) {
      zeros.start = (s.start[i] == s.start[of]) | (s.start[i] == s.end[of]);
      zeros.end = (s.end[i] == s.start[of]) | (s.end[i] == s.end[of]);
      zeros.along = (s.start[of] == s.start[i]) | (s.start[of] == s.end[i]);
      zeros.left = (s.end[of] == s.start[i]) | (s.end[of] == s.end[i]);
    }
    const auto [start, end, along, left] =
        sides(lanes, lanes.get(ways, of), a, lanes.get(ways, i), zeros);
    const bool right = (start >= 0) & (end < 0) & (along < 0) & (left <= 0);
    const bool right_of_other = (along >= 0) & (left > 0) & (start < 0) & (end >= 0);
    const bool at_end = (left == 0) & (start <= 0) & (end >= 0) & !((end == 0) & (start < 0));
    const bool at_end_of_other =
        (end == 0) & (along <= 0) & (left <= 0) & !((left == 0) & (along < 0));
    return (right ? kBitOf[0] : 0) | (right_of_other ? kBitOf[8] : 0) | (at_end ? kBitOf[16] : 0) |
           (at_end_of_other ? kBitOf[24] : 0);
  };
  const PairBits<4> found = test_rows<4>(numbers, rows, pairs, kinds);
  const auto& [right, right_of_other, at_end, at_end_of_other] = found.kinds;
  return {right, right_of_other, at_end, at_end_of_other, found.exact};
}

}  // namespace minksum

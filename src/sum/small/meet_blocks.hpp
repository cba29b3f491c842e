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
  /// At the end of r, t leads to the left of r, or is on its line.
  LaneBits at_end = 0;
  LaneBits at_end_of_other = 0;
  /// How many pairs doubles did not decide.
  std::size_t exact = 0;
};

alignas(64) inline constexpr std::array<LaneBits, kLanes> kByteOf{0, 8, 16, 24, 32, 40, 48, 56};

/// Exchanges rows and columns of eight by eight bits.
[[nodiscard]] constexpr LaneBits transposed(LaneBits bits) {
  const auto exchange = [&](int shift, LaneBits mask) {
    const LaneBits changed = (bits ^ (bits >> shift)) & mask;
    bits ^= changed ^ (changed << shift);
  };
  exchange(7, 0x00AA00AA00AA00AA);
  exchange(14, 0x0000CCCC0000CCCC);
  exchange(28, 0x00000000F0F0F0F0);
  return bits;
}

/// Finds the meetings of the segments `rows` of a block with those of another block, as far as
/// `pairs` are concerned.
template <class Number>
[[gnu::always_inline]] inline BlockMeetings meet_blocks(const SmallNumbers<Number>& numbers,
                                                        const SmallSegments& s, std::size_t block,
                                                        std::size_t other, LaneBits rows,
                                                        LaneBits pairs) {
  const auto starts = s.at();
  const auto ways = s.way();
  // A lane has a byte for each of these, with a bit for each row. So lanes are united once for all
  // rows: that takes as long as comparing a row.
  enum Kind : unsigned { kRight, kRightOfOther, kAtEnd, kAtEndOfOther, kUnsure };
  const auto bit_if = [](bool is_so, Kind kind) __attribute__((always_inline)) {
    return is_so ? LaneBits{1} << (kind * kLanes) : LaneBits{0};
  };
  const auto kinds = [&](const auto& lanes, std::size_t row, std::size_t t)
      __attribute__((always_inline)) {
    const std::size_t of = block * kLanes + row;
    const std::size_t i = other * kLanes + t;
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
    return bit_if(right, kRight) | bit_if(right_of_other, kRightOfOther) | bit_if(at_end, kAtEnd) |
           bit_if(at_end_of_other, kAtEndOfOther);
  };
  alignas(64) std::array<LaneBits, kLanes> found{};
  LaneBits near = 0;
  for (; rows != 0; rows &= rows - 1) {
    const auto row = static_cast<unsigned>(std::countr_zero(rows));
    if (s.in_part) {
      // Where parts are not near each other, segments meet inside the sum at most.
      const LaneBits seen =
          s.part.near(other, moved(s.box_of_part(block * kLanes + row), {}, numbers.reach));
      near |= seen << (row * kLanes);
      if ((seen & pairs >> (row * kLanes)) == 0) continue;
    }
    for (std::size_t t = 0; t < kLanes; ++t) {
      if constexpr (std::is_same_v<Number, double>) {
        found[t] |= kinds(ExactLanes{}, row, t) << row;
      } else {
        bool is_unsure = false;
        const LaneBits bits = kinds(filter_lanes(numbers, is_unsure), row, t);
        found[t] |= (bits | bit_if(is_unsure, kUnsure)) << row;
      }
    }
  }
  pairs = transposed(s.in_part ? pairs & near : pairs);
  BlockMeetings meetings;
  LaneBits unsure = 0;
#pragma GCC unroll 1  // unrolled, it would be no vector code
  for (std::size_t t = 0; t < kLanes; ++t) {
    const auto byte = [&](Kind kind) __attribute__((always_inline)) {
      return (found[t] >> (kind * kLanes) & 0xFF) << kByteOf[t];
    };
    meetings.right |= byte(kRight);
    meetings.right_of_other |= byte(kRightOfOther);
    meetings.at_end |= byte(kAtEnd);
    meetings.at_end_of_other |= byte(kAtEndOfOther);
    unsure |= byte(kUnsure);
  }
  meetings.right &= pairs;
  meetings.right_of_other &= pairs;
  meetings.at_end &= pairs;
  meetings.at_end_of_other &= pairs;
  if constexpr (!std::is_same_v<Number, double>) {
    for_each_bit(unsure & pairs, [&](std::uint32_t bit) {
      const auto exact = [&](const auto& lanes) __attribute__((always_inline)) {
        return kinds(lanes, bit % kLanes, bit / kLanes);
      };
      const LaneBits sure = compute_surely(numbers, exact);
      const auto set = [&](LaneBits& bits, Kind kind) {
        bits = (bits & ~kBitOf[bit]) | (sure >> (kind * kLanes) & 1) << bit;
      };
      set(meetings.right, kRight);
      set(meetings.right_of_other, kRightOfOther);
      set(meetings.at_end, kAtEnd);
      set(meetings.at_end_of_other, kAtEndOfOther);
      ++meetings.exact;
    });
  }
  return meetings;
}

}  // namespace minksum

// Finds the meetings of two blocks of eight segments.
#pragma once

#include "sum/small/sides.hpp"
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
  constexpr LaneBits kOfLane = 0x01010101;  // one byte for each kind
  BlockMeetings meetings;
  for (; rows != 0; rows &= rows - 1) {
    const auto row = static_cast<unsigned>(std::countr_zero(rows));
    const std::size_t of = block * kLanes + row;
    const Vec<double> at{s.x[of], s.y[of]};
    const Vec<double> way{s.dx[of], s.dy[of]};
    const auto kinds = [&](const auto& cross, std::size_t t) __attribute__((always_inline)) {
      const auto [start, end, along, left] =
          sides(cross, way, {x[t] - at.x, y[t] - at.y}, {dx[t], dy[t]});
      const bool right = (start >= 0) & (end < 0) & (along < 0) & (left <= 0);
      const bool right_of_other = (along >= 0) & (left > 0) & (start < 0) & (end >= 0);
      const bool at_end = (left == 0) & (start <= 0) & (end >= 0) & !((end == 0) & (start < 0));
      const bool at_end_of_other =
          (end == 0) & (along <= 0) & (left <= 0) & !((left == 0) & (along < 0));
      return (right ? kBitOf[t] : 0) | (right_of_other ? kBitOf[t + kLanes] : 0) |
             (at_end ? kBitOf[t + 2 * kLanes] : 0) | (at_end_of_other ? kBitOf[t + 3 * kLanes] : 0);
    };
    const LaneBits bits = test_lanes<Number, kOfLane>(kLanes, kinds);
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

// Finds the meetings of up to 64 segments.
#pragma once

#include "sum/small/small_segments.hpp"

namespace minksum {

/// The segments, of up to 64, to which the walk may switch from one segment.
struct SmallMeetingBits {
  LaneBits right = 0;   ///< segments that lead to its right from a point behind its start
  LaneBits at_end = 0;  ///< at its end: segments that lead to its left, lie on its line or end
};

/// Returns those of the first `count` segments that segment `of` meets.
template <class Number>
[[gnu::always_inline]] inline SmallMeetingBits meetings_among(const SmallSegments& s,
                                                              std::uint32_t of, std::size_t count) {
  const auto x = static_cast<Number>(s.x[of]);
  const auto y = static_cast<Number>(s.y[of]);
  const auto dx = static_cast<Number>(s.dx[of]);
  const auto dy = static_cast<Number>(s.dy[of]);
  SmallMeetingBits bits;
  for (std::size_t t = 0; t < count / kLanes * kLanes; ++t) {
    const Number ax = static_cast<Number>(s.x[t]) - x;
    const Number ay = static_cast<Number>(s.y[t]) - y;
    const auto tx = static_cast<Number>(s.dx[t]);
    const auto ty = static_cast<Number>(s.dy[t]);
    const Number start = dx * ay - dy * ax;  // how far t starts on the left
    const Number turn = dx * ty - dy * tx;   // and how much farther it ends there
    const Number end = start + turn;
    const Number along = ax * ty - ay * tx;  // they meet at along / turn of the way
    const bool right = (start >= 0) & (end < 0) & (along < 0) & (along >= turn);
    const bool at_end = (along == turn) & (start <= 0) & (end >= 0);
    bits.right |= right ? kBitOf[t] : 0;
    bits.at_end |= at_end ? kBitOf[t] : 0;
  }
  return bits;
}

/// The meetings of up to 64 segments. Each meeting on the right has a number.
struct SmallMeetingSets {
  static constexpr std::size_t kMaxSegments = 64;
  static constexpr std::size_t kMax = kMaxSegments * kMaxSegments;

  std::uint32_t right_count;  ///< number of meetings on the right
  std::array<SmallMeetingBits, kMaxSegments> of;

  /// Calls visit(meeting) for all meetings on the right.
  template <class Visit>
  void for_each_number(std::uint32_t segments, Visit visit) const {
    for (std::uint32_t at = 0; at < segments; ++at) {
      for_each_right(at, [&](std::uint32_t, std::size_t meeting) { visit(meeting); });
    }
  }
  /// Calls visit(segment, meeting) for the meetings on the right of a segment.
  template <class Visit>
  [[gnu::always_inline]] void for_each_right(std::uint32_t at, Visit visit) const {
    for_each_bit(of[at].right, [&](std::uint32_t t) { visit(t, kMaxSegments * at + t); });
  }
  /// Calls visit(segment) for the meetings at the end of a segment.
  template <class Visit>
  [[gnu::always_inline]] void for_each_at_end(std::uint32_t at, Visit visit) const {
    for_each_bit(of[at].at_end, visit);
  }
};

/// Finds all meetings. Returns false if there are too many.
template <class Number>
[[gnu::always_inline]] inline bool find_meetings(const SmallSegments& s, SmallMeetingSets& m) {
  const LaneBits all = first_bits(s.size);
  m.right_count = 0;
  for (std::uint32_t at = 0; at < s.size; ++at) {
    const SmallMeetingBits bits = meetings_among<Number>(s, at, filled_up(s.size));
    m.of[at] = {bits.right & all, bits.at_end & all & ~kBitOf[at]};
    m.right_count += static_cast<std::uint32_t>(std::popcount(bits.right & all));
    if (m.right_count > most_right_meetings(at)) return false;
  }
  return true;
}

}  // namespace minksum

// Where the segments of a small convolution meet.
#pragma once

#include "small_sum/blocks.hpp"
#include "small_sum/small_segments.hpp"

namespace minksum {

/// Whom a segment meets on its way and may be left for, of up to 64.
struct SmallMeetingBits {
  LaneBits right = 0;   ///< those that lead to its right from a point behind its start
  LaneBits at_end = 0;  ///< at its end: those that lead to its left, are on its line, or end there
};

/// Those that segment `of` meets among up to 64 from `first` on.
template <class Number>
[[gnu::always_inline]] inline SmallMeetingBits meetings_among(const SmallSegments& s,
                                                              std::uint32_t of, std::size_t first,
                                                              std::size_t count) {
  const auto x = static_cast<Number>(s.x[of]);
  const auto y = static_cast<Number>(s.y[of]);
  const auto dx = static_cast<Number>(s.dx[of]);
  const auto dy = static_cast<Number>(s.dy[of]);
  const double* const other_x = s.x.data() + first;
  const double* const other_y = s.y.data() + first;
  const double* const other_dx = s.dx.data() + first;
  const double* const other_dy = s.dy.data() + first;
  SmallMeetingBits bits;
  for (std::size_t t = 0; t < count / kLanes * kLanes; ++t) {
    const Number ax = static_cast<Number>(other_x[t]) - x;
    const Number ay = static_cast<Number>(other_y[t]) - y;
    const auto tx = static_cast<Number>(other_dx[t]);
    const auto ty = static_cast<Number>(other_dy[t]);
    const Number start = dx * ay - dy * ax;  // how far t starts on the left
    const Number turn = dx * ty - dy * tx;   // and how much farther it ends there
    const Number end = start + turn;
    const Number along = ax * ty - ay * tx;  // they meet at along / turn of the way
    const bool to_right = (start >= 0) & (end < 0) & (along < 0) & (along >= turn);
    const bool ends = (along == turn) & (start <= 0) & (end >= 0);
    bits.right |= to_right ? kBitOf[t] : 0;
    bits.at_end |= ends ? kBitOf[t] : 0;
  }
  return bits;
}

/// The meetings of up to 64 segments. A meeting has a number.
struct SmallMeetingSets {
  static constexpr std::size_t kMaxSegments = 64;
  static constexpr std::size_t kMax = kMaxSegments * kMaxSegments;

  std::uint32_t right_count;  ///< of meetings on the right
  std::array<SmallMeetingBits, kMaxSegments> of;

  /// Calls visit(segment, meeting).
  template <class Visit>
  [[gnu::always_inline]] void for_each_right(std::uint32_t at, Visit visit) const {
    for_each_bit(of[at].right, [&](std::uint32_t t) { visit(t, kMaxSegments * at + t); });
  }
  /// Calls visit(segment).
  template <class Visit>
  [[gnu::always_inline]] void for_each_at_end(std::uint32_t at, Visit visit) const {
    for_each_bit(of[at].at_end, visit);
  }
};

/// Where so many segments have more meetings on the right most corners lie inside, and the stages
/// are faster.
[[nodiscard]] constexpr std::uint32_t most_right_meetings(std::uint32_t segments) {
  return segments + 16;
}

/// False if there are too many.
template <class Number>
[[gnu::always_inline]] inline bool find_meetings(const SmallSegments& s, SmallMeetingSets& m) {
  const LaneBits all = first_bits(s.size);
  m.right_count = 0;
  for (std::uint32_t at = 0; at < s.size; ++at) {
    const SmallMeetingBits bits = meetings_among<Number>(s, at, 0, filled_up(s.size));
    m.of[at] = {bits.right & all, bits.at_end & all & ~kBitOf[at]};
    m.right_count += static_cast<std::uint32_t>(std::popcount(bits.right & all));
    if (m.right_count > most_right_meetings(at)) return false;
  }
  return true;
}

/// The meetings of any number of segments.
struct SmallMeetingLists {
  static constexpr std::size_t kMax = 8 * SmallSegments::kMax;
  struct Run {
    std::uint32_t begin;
    std::uint32_t end;
  };

  std::uint32_t right_count;
  std::uint32_t at_end_count;
  std::array<Run, SmallSegments::kMax> right_of;
  std::array<Run, SmallSegments::kMax> at_end_of;
  std::array<std::uint16_t, kMax> right;
  std::array<std::uint16_t, kMax> at_end;

  template <class Visit>
  [[gnu::always_inline]] void for_each_right(std::uint32_t at, Visit visit) const {
    for (std::uint32_t k = right_of[at].begin; k < right_of[at].end; ++k) visit(right[k], k);
  }
  template <class Visit>
  [[gnu::always_inline]] void for_each_at_end(std::uint32_t at, Visit visit) const {
    for (std::uint32_t k = at_end_of[at].begin; k < at_end_of[at].end; ++k) visit(at_end[k]);
  }
};

/// False if there are too many. O(s²) for s segments, but blocks of eight that are elsewhere take
/// one look.
template <class Number>
[[gnu::always_inline]] inline bool find_meetings(const SmallSegments& s, SmallMeetingLists& m) {
  SmallBlocks blocks;
  blocks.set(s.x.data(), s.y.data(), s.dx.data(), s.dy.data(), s.size);
  m.right_count = 0;
  m.at_end_count = 0;
  for (std::uint32_t at = 0; at < s.size; ++at) {
    if (std::max(m.right_count, m.at_end_count) + s.size > SmallMeetingLists::kMax) return false;
    m.right_of[at].begin = m.right_count;
    m.at_end_of[at].begin = m.at_end_count;
    for_each_bit(blocks.near(s.x[at], s.y[at], s.dx[at], s.dy[at]), [&](std::uint32_t block) {
      const std::size_t first = block * kLanes;
      const SmallMeetingBits bits = meetings_among<Number>(s, at, first, kLanes);
      const LaneBits all = first_bits(s.size - first);
      for_each_bit(bits.right & all, [&](std::uint32_t i) {
        m.right[m.right_count++] = static_cast<std::uint16_t>(first + i);
      });
      for_each_bit(bits.at_end & all, [&](std::uint32_t i) {
        m.at_end[m.at_end_count] = static_cast<std::uint16_t>(first + i);
        m.at_end_count += first + i != at ? 1U : 0U;
      });
    });
    m.right_of[at].end = m.right_count;
    m.at_end_of[at].end = m.at_end_count;
    if (m.right_count > most_right_meetings(at)) return false;
  }
  return true;
}

}  // namespace minksum

// Finds the meetings of the segments of a small convolution.
#pragma once

#include <optional>

#include "machine/vectors.hpp"
#include "sum/small/meet_blocks.hpp"

namespace minksum {

/// The meetings of each segment. Each meeting has a number.
class SmallMeetings {
 public:
  static constexpr std::size_t kMax = 5 * SmallSegments::kMax;
  std::uint32_t right_count;  ///< number of meetings on the right
  /// Whether there would be too many among parts of the segments, too. That is so if they meet at
  /// ends, because they lie on few lines, or if doubles do not decide most pairs, because they are
  /// short.
  bool parts_would_not_help;

  void clear(std::uint32_t segments) {
    for (auto& last : last_) std::fill_n(last.begin(), segments, kNone);
    right_count = 0;
    parts_would_not_help = false;
    size_ = 0;
  }
  [[gnu::always_inline]] void add(std::size_t block, std::size_t other, const BlockMeetings& m) {
    const std::size_t r = block * kLanes;
    const std::size_t t = other * kLanes;
    const auto row = [r](std::uint32_t bit) { return r + bit % kLanes; };
    const auto lane = [t](std::uint32_t bit) { return t + bit / kLanes; };
    const auto add_all = [&](LaneBits bits, Kind kind) {
      for_each_bit(bits, [&](std::uint32_t bit) { add(row(bit), lane(bit), kind); });
    };
    const auto add_all_of_other = [&](LaneBits bits, Kind kind) {
      for_each_bit(bits, [&](std::uint32_t bit) { add(lane(bit), row(bit), kind); });
    };
    const std::uint32_t before = size_;
    add_all(m.right, kRight);
    if (block != other) add_all_of_other(m.right_of_other, kRight);
    right_count += size_ - before;
    add_all(m.at_end, kAtEnd);
    if (block != other) add_all_of_other(m.at_end_of_other, kAtEnd);
  }
  /// Returns the most meetings that so many segments may have. 31 sums with 4 to 6 for each segment
  /// took 0.75 of the stages' time on the geometric mean (0.23 to 2.2).
  [[nodiscard]] static constexpr std::size_t most(std::size_t segments) {
    return 6 * segments + 64;
  }
  /// Whether there is room for the meetings of two more blocks.
  [[nodiscard]] bool has_room() const { return size_ + 4 * kLanes * kLanes <= kMax; }

  /// Returns the number of all meetings. Those at ends have numbers, too.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Calls visit(segment, meeting) for the meetings on the right of a segment.
  template <class Visit>
  [[gnu::always_inline]] void for_each_right(std::uint32_t at, Visit visit) const {
    for (std::uint32_t k = last_[kRight][at]; k != kNone; k = pairs_[k].before) {
      visit(pairs_[k].other, std::size_t{k});
    }
  }
  /// Calls visit(segment) for the meetings at the end of a segment.
  template <class Visit>
  [[gnu::always_inline]] void for_each_at_end(std::uint32_t at, Visit visit) const {
    for (std::uint32_t k = last_[kAtEnd][at]; k != kNone; k = pairs_[k].before) {
      visit(pairs_[k].other);
    }
  }

 private:
  enum Kind : std::size_t { kRight, kAtEnd };
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Pair {
    std::uint32_t other;
    std::uint32_t before;  ///< number of the last meeting before, of the same segment and kind
  };
  [[gnu::always_inline]] void add(std::size_t segment, std::size_t other, Kind kind) {
    pairs_[size_] = {static_cast<std::uint32_t>(other), last_[kind][segment]};
    last_[kind][segment] = size_++;
  }

  std::uint32_t size_;
  std::array<std::array<std::uint32_t, SmallSegments::kMax>, 2> last_;
  std::array<Pair, kMax> pairs_;
};

/// Finds all meetings. Returns false if there are more than `most_right` on the right, or, without
/// that number, if the first segments have too many. Returns false as well if too many pairs of
/// blocks of eight are near one another.
template <class Number>
[[gnu::always_inline]] inline bool find_meetings(const SmallNumbers<Number>& numbers,
                                                 const SmallSegments& s,
                                                 std::optional<double> most_right,
                                                 SmallMeetings& m) {
  const SmallBlocks& blocks = s.blocks;
  const SegmentRows& boxes = s.boxes();
  m.clear(s.size);
  const std::size_t last = blocks.size() - 1;
  constexpr LaneBits kEachRow = 0x0101010101010101;
  constexpr LaneBits kDiagonal = 0x8040201008040201;
  const LaneBits pairs_with_last = s.lanes_of(last) * kEachRow;
  // A look compares a row with a block, in about a tenth of the stages' time for a segment. For any
  // sum, the stages take some microseconds more. With 8 looks a segment, 544 sums that come near
  // the limits took 1.015 times as long on the geometric mean. A pair that doubles do not decide
  // takes another look, or some four if numbers have more than 84 bits.
  const std::size_t most_looks = 12 * std::size_t{s.size} + 500;
  std::size_t looks_left = most_looks;
  const std::size_t looks_of_exact =
      std::is_same_v<Number, WideNumber> && numbers.reach > 0x1p36 ? 4 : 1;
  std::size_t looks_at_exact = 0;
  const auto meet = [&](std::size_t i, std::size_t j) __attribute__((always_inline)) {
    // The block with fewer rows near the other one is compared row by row.
    LaneBits rows = s.lanes_of(i);
    std::size_t block = i;
    std::size_t other = j;
    if (j != i) {
      rows &= boxes.near(i, blocks.box_of(j));
      const LaneBits rows_of_j = s.lanes_of(j) & boxes.near(j, blocks.box_of(i));
      if (std::popcount(rows_of_j) < std::popcount(rows)) {
        rows = rows_of_j;
        std::swap(block, other);
      }
    }
    const auto looks = static_cast<std::size_t>(std::popcount(rows));
    if (looks == 0) return true;
    if (looks > looks_left || !m.has_room()) {
      m.parts_would_not_help = looks_at_exact > most_looks / 2;
      return false;
    }
    looks_left -= looks;
    const LaneBits pairs =
        (other == last ? pairs_with_last : ~LaneBits{0}) & (j == i ? ~kDiagonal : ~LaneBits{0});
    const auto meetings = meet_blocks(numbers, s, block, other, rows, pairs);
    m.add(block, other, meetings);
    const std::size_t of_exact = looks_of_exact * meetings.exact;
    looks_at_exact += of_exact;
    looks_left -= std::min(looks_left, of_exact);
    return true;
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto meet_all = [&](std::size_t first, LaneBits near) __attribute__((always_inline)) {
      for (; near != 0; near &= near - 1) {
        if (!meet(i, first + static_cast<std::size_t>(std::countr_zero(near)))) return false;
      }
      return true;
    };
    if (!blocks.for_each_near(blocks.box_of(i), i, meet_all)) return false;
    // Blocks that come first are compared with more of the others, so they may have more. With
    // 2 - seen, the same 544 sums took 1.015 times as long.
    const double seen = std::min(static_cast<double>((i + 1) * kLanes) / s.size, 1.0);
    const auto many = static_cast<std::uint32_t>(s.size * seen * (1.5 - seen / 2));
    if (m.right_count > most_right.value_or(most_right_meetings(many))) return false;
    // Up to twice this share of all pairs has been seen.
    const auto most = SmallMeetings::most(std::min<std::size_t>(2 * (i + 1) * kLanes, s.size));
    if (!s.in_part && m.size() > most) {
      m.parts_would_not_help = true;
      return false;
    }
  }
  return true;
}

/// Finds meetings by such vectors, which the machine must have. Returns false if there are too many
/// meetings, or if finding them takes too long: the stages are faster then.
template <class Number>
bool find_meetings_by(Vectors vectors, const SmallNumbers<Number>& numbers, const SmallSegments& s,
                      SmallMeetings& m, std::optional<double> most_right = {}) {
  return with_vectors(
      vectors, [&]() __attribute__((always_inline)) {
        return find_meetings(numbers, s, most_right, m);
      });
}

}  // namespace minksum

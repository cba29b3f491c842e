// The walk along the outer boundary of a small convolution.
#pragma once

#include <algorithm>
#include <utility>

#include "number/wide_int.hpp"
#include "small_sum/small_segments.hpp"

namespace minksum {

/// A vertex of the boundary: where segment `segment` is left, or started, for what follows.
struct SmallCorner {
  std::uint32_t segment;  ///< that starts the edge there
  /// It is at along / whole of the segment.
  double along;
  double whole;
};

struct SmallBoundary {
  /// No piece between two crossings is walked twice.
  static constexpr std::size_t kMaxCorners = 4 * kMaxSmallSegments;
  std::uint32_t size = 0;
  std::array<SmallCorner, kMaxCorners> corners;
};

/// A fraction of a segment's way: numbers below 2^53.
struct SmallFraction {
  double above;
  double below;  ///< positive
};

[[nodiscard]] inline bool less(const SmallFraction& a, const SmallFraction& b) {
  const auto integer = [](double d) { return static_cast<Int128>(static_cast<std::int64_t>(d)); };
  return integer(a.above) * integer(b.below) < integer(b.above) * integer(a.below);
}

/// Walks along the boundary of the unbounded face, the sum on its left. One use.
class OuterWalk {
 public:
  OuterWalk(const SmallSegments& segments, const SmallMeetings& meetings, SmallBoundary& boundary)
      : s_(segments), m_(meetings), boundary_(boundary) {}

  /// From the smallest point. False if the walk does not come back, or might not be all of the
  /// sum's boundary.
  [[gnu::always_inline]] bool run(double start_x, double start_y) {
    boundary_.size = 0;
    std::uint32_t at = first_segment(start_x, start_y);
    if (at == kNone) return false;
    SmallFraction passed{0, 1};
    corner(at, passed);
    for (std::size_t steps = 0; steps < SmallBoundary::kMaxCorners - 1; ++steps) {
      const Next next = next_after(at, passed);
      if (next.segment == kNone) return false;
      if (next.turn != 0) corner(next.segment, next.passed);
      if (next.turn < 0) take(at, next.segment);
      at = next.segment;
      passed = next.passed;
      if (passed.above == 0 && s_.x[at] == start_x && s_.y[at] == start_y) {
        // Back at the start, the first corner is there already.
        --boundary_.size;
        return no_holes();
      }
    }
    return false;
  }

 private:
  static constexpr std::uint32_t kNone = kMaxSmallSegments;
  /// Where the walk goes on.
  struct Next {
    std::uint32_t segment = kNone;
    SmallFraction passed{0, 1};  ///< of that segment's way
    double turn = 0;             ///< negative: to the right
  };

  [[nodiscard]] double turn(std::uint32_t a, std::uint32_t b) const {
    return s_.dx[a] * s_.dy[b] - s_.dy[a] * s_.dx[b];
  }
  /// How far on the left of a segment another one starts.
  [[nodiscard]] double start_of(std::uint32_t t, std::uint32_t of) const {
    return s_.dx[of] * (s_.y[t] - s_.y[of]) - s_.dy[of] * (s_.x[t] - s_.x[of]);
  }
  void corner(std::uint32_t segment, const SmallFraction& passed) {
    boundary_.corners[boundary_.size++] = {segment, passed.above, passed.below};
  }
  /// Of those that start at the smallest point, the one that is farthest clockwise.
  [[gnu::always_inline]] std::uint32_t first_segment(double x, double y) {
    std::uint32_t first = kNone;
    for_each_bit(starting_at(s_, x, y), [&](std::uint32_t t) {
      if (first == kNone || turn(first, t) < 0) first = t;
    });
    return first;
  }
  /// The first ray counter-clockwise from where the walk came: to the right at the first place that
  /// offers it, else at the end, as far to the right as may be.
  [[gnu::always_inline]] Next next_after(std::uint32_t at, const SmallFraction& passed) {
    Next next;
    SmallFraction best{0, 0};
    for_each_bit(m_.right[at], [&](std::uint32_t t) {
      const double c = turn(at, t);
      const double along = (s_.x[t] - s_.x[at]) * s_.dy[t] - (s_.y[t] - s_.y[at]) * s_.dx[t];
      const SmallFraction place{-along, -c};
      if (passed.above != 0 && !less(passed, place)) return;
      if (next.segment != kNone) {
        if (less(best, place)) return;
        if (!less(place, best) && turn(next.segment, t) >= 0) return;
      }
      best = place;
      next = {t, {start_of(t, at), -c}, c};
    });
    return next.segment != kNone ? next : next_at_end(at);
  }
  [[gnu::always_inline]] Next next_at_end(std::uint32_t at) const {
    Next next;
    for_each_bit(m_.at_end[at], [&](std::uint32_t t) {
      const double c = turn(at, t);
      if (c == 0) {
        // What goes on straight is before all that turns to the left.
        const double to_x = s_.x[at] + s_.dx[at] - s_.x[t];
        const double to_y = s_.y[at] + s_.dy[at] - s_.y[t];
        const double along = s_.dx[t] * to_x + s_.dy[t] * to_y;
        const double whole = s_.dx[t] * s_.dx[t] + s_.dy[t] * s_.dy[t];
        const bool same_sense = s_.dx[at] * s_.dx[t] + s_.dy[at] * s_.dy[t] > 0;
        if (same_sense && along >= 0 && along < whole) next = {t, {along, whole}, 0};
        return;
      }
      const double start = start_of(t, at);
      if (start + c == 0) return;  // it ends there
      if (next.segment != kNone && (next.turn == 0 || turn(next.segment, t) >= 0)) return;
      next = {t, {-start, c}, c};
    });
    return next;
  }

  /// Whether this corner was not taken before.
  bool take(std::uint32_t from, std::uint32_t to) {
    const bool first = (taken_[from] & kBitOf[to]) == 0;
    taken_[from] |= kBitOf[to];
    taken_count_ += first ? 1U : 0U;
    return first;
  }

  /// A hole is walked with the sum on the left, too, and has three corners where it turns right,
  /// none of them one of the outer boundary. Where a walk from what looks like such a corner ends,
  /// there is none.
  [[gnu::always_inline]] bool no_holes() {
    for (std::uint32_t from = 0; from < s_.size && taken_count_ + 3 <= m_.right_count; ++from) {
      for (SmallMask left = m_.right[from]; (left &= ~taken_[from]) != 0;) {
        if (!ends(from, static_cast<std::uint32_t>(std::countr_zero(left)))) return false;
      }
    }
    return true;
  }
  /// Whether no hole is on the walk from this corner: it ends, or leads to a corner of an earlier
  /// one, or goes round with too few right turns.
  bool ends(std::uint32_t from, std::uint32_t to) {
    std::array<std::pair<std::uint32_t, std::uint32_t>, SmallBoundary::kMaxCorners> turns;
    std::size_t count = 0;
    take(from, to);
    turns[count++] = {from, to};
    std::uint32_t at = to;
    SmallFraction passed{start_of(to, from), -turn(from, to)};
    std::uint32_t since = 0;
    while (count < turns.size()) {
      const Next next = next_after(at, passed);
      // Each segment is left at its end once, unless it goes round without right turns.
      if (next.segment == kNone || ++since > s_.size) return true;
      if (next.turn < 0) {
        since = 0;
        if (!take(at, next.segment)) {
          const auto* const again =
              std::find(turns.begin(), turns.begin() + count, std::pair(at, next.segment));
          return turns.begin() + count - again < 3;
        }
        turns[count++] = {at, next.segment};
      }
      at = next.segment;
      passed = next.passed;
    }
    return false;
  }

  const SmallSegments& s_;
  const SmallMeetings& m_;
  SmallBoundary& boundary_;
  std::array<SmallMask, kMaxSmallSegments> taken_{};  ///< of those, by segments: walked
  unsigned taken_count_ = 0;
};

}  // namespace minksum

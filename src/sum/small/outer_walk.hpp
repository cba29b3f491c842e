// Walks along the outer boundary of a small convolution.
#pragma once

#include <cmath>
#include <type_traits>

#include "exact/wide_int.hpp"
#include "sum/small/small_meetings.hpp"
#include "sum/small/small_placement.hpp"

namespace minksum {

/// A vertex of the boundary. The edge after it is part of `segment`, and starts at along / whole of
/// the segment's way.
struct SmallCorner {
  std::uint32_t segment;
  Int128 along;
  Int128 whole;
};

struct SmallBoundary {
  static constexpr std::size_t kMax = 2 * SmallSegments::kMax;
  /// A sum with more rings is left to the stages. It is four times what an operand may have.
  static constexpr std::size_t kMaxRings = 128;
  std::uint32_t rings;                          ///< the outer ring and holes
  std::array<std::uint32_t, kMaxRings> end_of;  ///< the ends of their corners
  std::uint32_t size;
  std::uint32_t between;  ///< number of corners that are not the start of a segment
  std::array<SmallCorner, kMax> corners;
};

/// By meeting on the right: the walk that turned there, and that turn's number in the walk.
struct RightMeetings {
  struct WalkStep {
    std::uint16_t walk;  ///< 0: none
    std::uint16_t number;
  };
  std::array<WalkStep, SmallMeetings::kMax> of;
};

/// Walks along the boundary of the unbounded face, with the sum on the left, and along those of
/// holes. May be used once.
template <class Number>
class OuterWalk {
 public:
  OuterWalk(const SmallSegments& segments, const SmallMeetings& meetings, SmallPlacement& placement,
            RightMeetings& turns, SmallBoundary& boundary)
      : s_(segments), m_(meetings), placement_(placement), turns_(turns), boundary_(boundary) {
    std::fill_n(turns_.of.begin(), m_.size(), RightMeetings::WalkStep{0, 0});
  }

  /// Walks from the smallest point. Returns false if the walk does not come back, or might not be
  /// all of the sum's boundary.
  bool run(double start_x, double start_y) {
    boundary_.size = 0;
    boundary_.between = 0;
    const std::uint32_t first = first_segment(start_x, start_y);
    if (first == kNone) return false;
    WalkLocation place{first, {0, 1}};
    std::uint32_t taken = 0;
    do {
      corner(place);
      Next next;
      do {
        next = next_after(place);
        if (next.place.segment == kNone) return false;
        place = next.place;
      } while (next.turn == 0);
      if (next.turn < 0) {
        turns_.of[next.meeting] = {1, 0};
        ++taken;
      }
      if (boundary_.size == SmallBoundary::kMax) return false;
    } while (place.passed.above != 0 || s_.x[place.segment] != start_x ||
             s_.y[place.segment] != start_y);
    boundary_.rings = 1;
    boundary_.end_of[0] = boundary_.size;
    return taken + 3 > m_.right_count || find_holes(taken);
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr bool kShort = std::is_same_v<Number, double>;
  using Integer = std::conditional_t<kShort, std::int64_t, Int128>;
  /// A fraction of a segment's way.
  struct Fraction {
    Integer above;
    Integer below;  ///< positive
  };
  /// A segment, and how much of its way has been passed.
  struct WalkLocation {
    std::uint32_t segment = kNone;
    Fraction passed{0, 1};
  };
  /// The place at which the walk goes on, and the turn that it takes.
  struct Next {
    WalkLocation place;
    Number turn = 0;  ///< negative if to the right
    std::size_t meeting = 0;
  };

  [[nodiscard]] Number turn(std::uint32_t a, std::uint32_t b) const {
    return cross(way(a), way(b));
  }
  /// Returns how far on the left of a segment another one starts.
  [[nodiscard]] Number start_of(std::uint32_t t, std::uint32_t of) const {
    return cross(way(of), between(of, t));
  }
  [[nodiscard]] Vec<Number> way(std::uint32_t t) const {
    return whole_numbers<Number>({s_.dx[t], s_.dy[t]});
  }
  [[nodiscard]] Vec<Number> between(std::uint32_t from, std::uint32_t to) const {
    return whole_numbers<Number>({s_.x[to] - s_.x[from], s_.y[to] - s_.y[from]});
  }
  [[nodiscard]] static Fraction fraction(Number above, Number below) {
    return {static_cast<Integer>(above), static_cast<Integer>(below)};
  }
  [[nodiscard]] static bool less(const Fraction& a, const Fraction& b) {
    using Wide = std::conditional_t<kShort, Int128, WideInt<4>>;
    return product<Wide>(a.above, b.below) < product<Wide>(b.above, a.below);
  }
  void corner(const WalkLocation& place) {
    boundary_.corners[boundary_.size++] = {place.segment, place.passed.above, place.passed.below};
    if (place.passed.above != 0) ++boundary_.between;
  }
  /// Returns the farthest clockwise of all segments that start at the smallest point.
  [[nodiscard]] std::uint32_t first_segment(double x, double y) const {
    std::uint32_t first = kNone;
    for (std::uint32_t t = 0; t < s_.size; ++t) {
      if (s_.x[t] != x || s_.y[t] != y) continue;
      if (first == kNone || is_preferred(t, first)) first = t;
    }
    return first;
  }

  /// Returns the first ray counter-clockwise from where the walk came. It leads to the right at the
  /// first place that offers such a ray. Otherwise it starts at the end, as far to the right as
  /// possible.
  [[nodiscard, gnu::always_inline]] Next next_after(const WalkLocation& place) {
    const std::uint32_t at = place.segment;
    Next next;
    Fraction best{0, 0};
    m_.for_each_right(at, [&](std::uint32_t t, std::size_t meeting) {
      const Number c = turn(at, t);
      const Fraction here = fraction(-cross(between(at, t), way(t)), -c);
      if (place.passed.above != 0 && !less(place.passed, here)) return;
      if (next.place.segment != kNone) {
        if (less(best, here)) return;
        if (!less(here, best) && !is_preferred(t, next.place.segment)) return;
      }
      best = here;
      next.place.segment = t;
      next.turn = c;
      next.meeting = meeting;
    });
    if (next.place.segment == kNone) return next_at_end(at);
    next.place.passed = fraction(start_of(next.place.segment, at), -next.turn);
    return next;
  }
  [[nodiscard, gnu::always_inline]] Next next_at_end(std::uint32_t at) {
    Next next;
    std::uint32_t looks = 0;
    m_.for_each_at_end(at, [&](std::uint32_t t) {
      ++looks;
      const Number c = turn(at, t);
      if (c == 0) {
        // A segment that goes straight on comes before all that turn to the left.
        const WalkLocation along = straight_on(at, t);
        if (along.segment == kNone) return;
        const bool is_straight = next.turn == 0 && next.place.segment != kNone;
        if (!is_straight || s_.is_before(next.place.segment, t)) next = {along, 0, 0};
        return;
      }
      const Number start = start_of(t, at);
      if (start + c == 0) return;  // t ends there
      const bool first = next.place.segment == kNone;
      if (first || (next.turn != 0 && is_preferred(t, next.place.segment))) {
        next = {{t, fraction(-start, c)}, c, 0};
      }
    });
    looks_ += looks;
    return next;
  }
  /// Whether ray t is preferred to ray `other` from the same place. The ray on the right is
  /// preferred. Of two rays in the same direction, the one that was listed first is.
  [[nodiscard, gnu::always_inline]] bool is_preferred(std::uint32_t t, std::uint32_t other) const {
    const Number c = turn(other, t);
    return c < 0 || (c == 0 && s_.is_before(t, other));
  }
  /// Returns where the end of `at` is on a segment t of the same line, if t leads on from there.
  [[nodiscard, gnu::noinline]] WalkLocation straight_on(std::uint32_t at, std::uint32_t t) const {
    // Places are taken along the axis that the line is closer to.
    const bool by_x = std::abs(s_.dx[t]) >= std::abs(s_.dy[t]);
    const double whole = by_x ? s_.dx[t] : s_.dy[t];
    const double along = by_x ? s_.x[at] + s_.dx[at] - s_.x[t] : s_.y[at] + s_.dy[at] - s_.y[t];
    const double sense = whole < 0 ? -1 : 1;
    const bool same_sense = sense * (by_x ? s_.dx[at] : s_.dy[at]) > 0;
    if (!same_sense || sense * along < 0 || sense * along >= sense * whole) return {};
    return {t, {whole_number<Integer>(sense * along), whole_number<Integer>(sense * whole)}};
  }

  /// Finds all holes. Returns false if there may be others. A walk around a hole has the sum on its
  /// left, too, and turns right at three corners. None of these is a corner of the outer boundary.
  /// If a walk from a possible corner of this kind ends, it is no hole's.
  [[nodiscard]] bool find_holes(std::uint32_t taken) {
    looks_ = 0;
    std::uint16_t walk = 1;
    bool sure = true;
    for (std::uint32_t from = 0; from < s_.size && sure && taken + 3 <= m_.right_count; ++from) {
      m_.for_each_right(from, [&](std::uint32_t to, std::size_t meeting) {
        if (turns_.of[meeting].walk == 0) sure = sure && look(from, to, meeting, ++walk, taken);
      });
    }
    return sure;
  }
  /// Walks from this corner. No hole is there if the walk ends, leads to a corner of an earlier
  /// walk, or goes round with too few right turns. Returns false if there may be one or not.
  bool look(std::uint32_t from, std::uint32_t to, std::size_t meeting, std::uint16_t walk,
            std::uint32_t& taken) {
    std::uint16_t count = 0;
    turns_.of[meeting] = {walk, count++};
    ++taken;
    WalkLocation place{to, fraction(start_of(to, from), -turn(from, to))};
    for (std::uint32_t lefts = 0; lefts <= s_.size; ++lefts) {
      // With more looks the stages are faster. With 6 a segment, 6 of 95 sums gave up too early.
      if (++looks_ > 14 * s_.size + 1000) return false;
      const Next next = next_after(place);
      if (next.place.segment == kNone) return true;
      if (next.turn < 0) {
        RightMeetings::WalkStep& turn = turns_.of[next.meeting];
        if (turn.walk != 0) {
          return turn.walk != walk || count - turn.number < 3 ||
                 add_if_hole(next.meeting, next.place);
        }
        turn = {walk, count++};
        ++taken;
        lefts = 0;
      }
      place = next.place;
    }
    // Where a walk leaves a segment at its end depends on the segment alone. So this walk goes
    // round without right turns.
    return true;
  }

  /// Walks around from a corner, to which the walk comes back, and keeps the ring if it is a
  /// hole's: if a point just on its right is outside the sum. Returns false if that is not known.
  [[nodiscard, gnu::noinline]] bool add_if_hole(std::size_t meeting, WalkLocation place) {
    if (boundary_.rings == SmallBoundary::kMaxRings) return false;
    const std::uint32_t between_before = boundary_.between;
    Piece longest;
    Next next;
    do {
      if (boundary_.size == SmallBoundary::kMax) return false;
      corner(place);
      do {
        next = next_of_ring(place);
        const Piece piece = piece_between(place, next);
        if (piece.to - piece.from > longest.to - longest.from) longest = piece;
        place = next.place;
      } while (next.turn == 0);
    } while (next.turn > 0 || next.meeting != meeting);
    using Result = SmallPlacement::Result;
    const Result result = placement_.test(s_, longest.segment, longest.from, longest.to);
    if (result == Result::kOutside) {
      boundary_.end_of[boundary_.rings++] = boundary_.size;
    } else {
      boundary_.size = boundary_.end_of[boundary_.rings - 1];
      boundary_.between = between_before;
    }
    return result != Result::kUnknown;
  }
  /// The same as next_after, out of line: rings are few.
  [[nodiscard, gnu::noinline]] Next next_of_ring(const WalkLocation& place) {
    return next_after(place);
  }
  /// A part of a segment, between two rounded fractions of its way.
  struct Piece {
    std::uint32_t segment = kNone;
    double from = 0;
    double to = 0;
  };
  [[nodiscard]] Piece piece_between(const WalkLocation& place, const Next& next) const {
    const auto quotient = [](const auto& above, const auto& below) {
      return static_cast<double>(above) / static_cast<double>(below);
    };
    const std::uint32_t at = place.segment;
    const std::uint32_t t = next.place.segment;
    const double from = quotient(place.passed.above, place.passed.below);
    if (next.turn >= 0) return {at, from, 1};
    return {at, from, quotient(cross(between(at, t), way(t)), turn(at, t))};
  }

  const SmallSegments& s_;
  const SmallMeetings& m_;
  SmallPlacement& placement_;
  RightMeetings& turns_;
  SmallBoundary& boundary_;
  std::uint32_t looks_ = 0;  ///< looks at places and at ends, by walks that look for holes
};

}  // namespace minksum

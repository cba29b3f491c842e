// Walks along the boundary of a small sum: its outer ring and its holes.
#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>

#include "sum/small/small_meetings.hpp"
#include "sum/small/small_placement.hpp"
#include "sum/small/way_fractions.hpp"

namespace minksum {

/// A vertex of the boundary. The edge after it is part of `segment`, and starts where another
/// segment crosses it, or at its own start if there is none.
struct SmallCorner {
  std::uint32_t segment;
  std::uint32_t crossed_by;

  [[nodiscard]] bool is_start() const { return crossed_by == kNoSegment; }
};

struct SmallBoundary {
  static constexpr std::size_t kMax = 2 * SmallSegments::kMax;
  /// By ring: the index behind its last corner. The ring through the smallest point comes first,
  /// then other outer rings and holes.
  std::vector<std::uint32_t> end_of;
  /// Places at which a ring may go from one part of the sum to another one that only touches it.
  std::vector<SmallCorner> touching;
  std::uint32_t size;
  std::uint32_t between;  ///< number of corners that are not the start of a segment
  std::array<SmallCorner, kMax> corners;
};

/// Where walks have been. Walks have numbers from 1 on, and 0 stands for none.
struct WalkMarks {
  struct Mark {
    std::uint32_t walk;
    std::uint32_t turns;  ///< how many turns to the right the walk had taken before
  };
  std::array<Mark, SmallMeetings::kMax> turn_at;  ///< by meeting on the right
  /// By segment: where a walk left it at its end. How a walk goes on from there depends on the
  /// segment alone.
  std::array<Mark, SmallSegments::kMax> left_end_of;
  // Of an operand of several polygons:
  std::vector<std::uint32_t> ring_of;   ///< by entry
  std::vector<std::uint32_t> smallest;  ///< vertex by outer ring
};

/// Walks along the boundary of the unbounded face, with the sum on the left, and along all other
/// rings of the boundary. With `kSeveral`, one operand has several polygons. May be used once.
template <class Number, bool kSeveral>
class BoundaryWalk {
 public:
  BoundaryWalk(const SmallNumbers<Number>& numbers, const SmallSegments& segments,
               const SmallMeetings& meetings, SmallPlacement& placement, WalkMarks& marks,
               SmallBoundary& boundary)
      : s_(segments),
        m_(meetings),
        ways_(numbers, segments),
        placement_(placement),
        marks_(marks),
        boundary_(boundary) {
    std::memset(marks_.turn_at.data(), 0, m_.size() * sizeof(WalkMarks::Mark));
    std::memset(marks_.left_end_of.data(), 0, s_.size * sizeof(WalkMarks::Mark));
    boundary_.size = 0;
    boundary_.end_of.clear();
    boundary_.touching.clear();
    boundary_.between = 0;
    if constexpr (kSeveral) {
      several_ = s_.operands[0]->has_several() ? 0 : 1;
      find_rings(*s_.operands[several_], marks_.ring_of, marks_.smallest);
    }
  }

  /// Walks from the smallest point, the sum of two vertices. Returns false if the walk does not
  /// come back, or might not be all of the sum's boundary.
  bool run(const VecRow& p, std::size_t i, const VecRow& q, std::size_t j) {
    const auto starts_there = [&](std::uint32_t segment) {
      return ways_.starts_at(segment, plus(p[i], q[j]), [&](const auto& lanes) {
        return plus(lanes.get(p, i), lanes.get(q, j));
      });
    };
    const std::uint32_t first = first_segment(starts_there);
    if (first == kNoSegment) return false;
    WalkLocation place{first, {}};
    std::uint32_t taken = 0;
    do {
      corner(place);
      Next next;
      do {
        next = next_after(place);
        if (next.place.segment == kNoSegment) return false;
        if (next.turn >= 0) marks_.left_end_of[place.segment] = {1, 0};
        note_touch(place, next);
        place = next.place;
      } while (next.turn == 0);
      if (next.turn < 0) {
        marks_.turn_at[next.meeting] = {1, 0};
        ++taken;
      }
      if (boundary_.size == SmallBoundary::kMax) return false;
    } while (!place.passed.is_start() || !starts_there(place.segment));
    end_ring();
    if constexpr (kSeveral) {
      if (!find_outer_rings(taken)) return false;
    }
    return taken + 3 > m_.right_count || find_holes(taken);
  }

 private:
  /// A segment, and how much of its way has been passed.
  struct WalkLocation {
    std::uint32_t segment = kNoSegment;
    WayFraction<Number> passed;
  };
  /// The place at which the walk goes on, and the turn that it takes.
  struct Next {
    WalkLocation place;
    double turn = 0;  ///< negative if to the right
    std::size_t meeting = 0;
  };

  void corner(const WalkLocation& place) {
    boundary_.corners[boundary_.size++] = {place.segment, place.passed.by};
    if (!place.passed.is_start()) ++boundary_.between;
  }
  void end_ring() { boundary_.end_of.push_back(boundary_.size); }
  /// Returns the place on segment t where it leaves another one.
  [[nodiscard, gnu::always_inline]] WalkLocation leave(std::uint32_t from, std::uint32_t t) const {
    return {t, ways_.entry(t, from, ways_.start_of(t, from), ways_.turn(from, t))};
  }
  /// Returns the farthest clockwise of all segments that start at the smallest point.
  template <class StartsThere>
  [[nodiscard]] std::uint32_t first_segment(const StartsThere& starts_there) const {
    std::uint32_t first = kNoSegment;
    for (std::uint32_t t = 0; t < s_.size; ++t) {
      if (!starts_there(t)) continue;
      if (first == kNoSegment || is_preferred(t, first)) first = t;
    }
    return first;
  }

  /// Returns the first ray counter-clockwise from where the walk came. (A ray is what lies ahead on
  /// a segment, from a place on it.) It leads to the right at the
  /// first place that offers such a ray. Otherwise it starts at the end, as far to the right as
  /// possible.
  [[nodiscard, gnu::always_inline]] Next next_after(const WalkLocation& place) {
    const std::uint32_t at = place.segment;
    Next next;
    WayFraction<Number> best;
    m_.for_each_right(at, [&](std::uint32_t t, std::size_t meeting) {
      const WayFraction<Number> here = ways_.crossing(at, t);
      if (!place.passed.is_start() && !ways_.less(at, place.passed, here)) return;
      if (next.place.segment != kNoSegment) {
        if (ways_.less(at, best, here)) return;
        if (!ways_.less(at, here, best) && !is_preferred(t, next.place.segment)) return;
      }
      best = here;
      next.place.segment = t;
      next.meeting = meeting;
    });
    if (next.place.segment == kNoSegment) return next_at_end(at);
    next.place = leave(at, next.place.segment);
    next.turn = -1;
    return next;
  }
  [[nodiscard, gnu::always_inline]] Next next_at_end(std::uint32_t at) {
    Next next;
    m_.for_each_at_end(at, [&](std::uint32_t t) {
      const double c = ways_.turn(at, t);
      if (c == 0) {
        // A segment that goes straight on comes before all that turn to the left.
        const auto passed = ways_.straight_on(t, at);
        if (!passed) return;
        const bool is_straight = next.turn == 0 && next.place.segment != kNoSegment;
        if (!is_straight || s_.is_before(next.place.segment, t)) next = {{t, *passed}, 0, 0};
        return;
      }
      const double start = ways_.start_of(t, at);
      if (ways_.end_of(t, at, start, c) == 0) return;  // t ends there
      const bool first = next.place.segment == kNoSegment;
      if (first || (next.turn != 0 && is_preferred(t, next.place.segment))) {
        next = {{t, ways_.entry(t, at, start, c)}, c, 0};
      }
    });
    return next;
  }
  /// Whether ray t is preferred to ray `other` from the same place. The ray on the right is
  /// preferred. Of two rays in the same direction, the one that was listed first is.
  [[nodiscard, gnu::always_inline]] bool is_preferred(std::uint32_t t, std::uint32_t other) const {
    const double c = ways_.turn(other, t);
    return c < 0 || (c == 0 && s_.is_before(t, other));
  }

  /// Finds the holes. Returns false if these may not be all. A walk around a hole has the sum on
  /// its left, too, and turns right at three corners. None of these is a corner of the outer
  /// boundary. If a walk from a right turn ends, that turn is no hole's corner.
  [[nodiscard]] bool find_holes(std::uint32_t taken) {
    bool sure = true;
    for (std::uint32_t from = 0; from < s_.size && sure && taken + 3 <= m_.right_count; ++from) {
      m_.for_each_right(from, [&](std::uint32_t to, std::size_t meeting) {
        if (marks_.turn_at[meeting].walk != 0) return;
        sure = sure && look(from, to, meeting, taken);
      });
    }
    return sure;
  }
  /// Walks from this corner. Returns false if it is not known whether a hole is there.
  bool look(std::uint32_t from, std::uint32_t to, std::size_t meeting, std::uint32_t& taken) {
    marks_.turn_at[meeting] = {++walk_, 0};
    ++taken;
    return follow(leave(from, to), 1, 3, taken);
  }
  /// Walks from a place, as `walk_`, and keeps the ring that it comes to. There is none if the walk
  /// ends, goes on as an earlier one, or goes round with less than `least` right turns. Returns
  /// false if that is not known. All walks together take O(turns + ends) steps.
  [[gnu::always_inline]] bool follow(WalkLocation place, std::uint32_t count, std::uint32_t least,
                                     std::uint32_t& taken) {
    for (;;) {
      const Next next = next_after(place);
      if (next.place.segment == kNoSegment) return true;
      if (next.turn < 0) {
        WalkMarks::Mark& turn = marks_.turn_at[next.meeting];
        if (turn.walk != 0) {
          return turn.walk != walk_ || count - turn.turns < least ||
                 add_if_boundary(next.place, [&](std::uint32_t, const Next& last) {
                   return last.turn < 0 && last.meeting == next.meeting;
                 });
        }
        turn = {walk_, count++};
        ++taken;
      } else {
        WalkMarks::Mark& end = marks_.left_end_of[place.segment];
        if (end.walk == 0) {
          end = {walk_, count};
        } else if (end.walk != walk_ || (least > 0 && end.turns == count)) {
          return true;  // as an earlier walk, or round without turns to the right
        } else if (kSeveral && end.turns == count && next.turn > 0) {
          return add_if_boundary(next.place, [&](std::uint32_t from, const Next& last) {
            return last.turn > 0 && from == place.segment;
          });
        }
      }
      place = next.place;
    }
  }

  /// Finds the other outer rings. Returns false if these may not be all. The smallest point of an
  /// outer ring is the sum of the smallest ones of two polygons.
  [[nodiscard, gnu::noinline]] bool find_outer_rings(std::uint32_t& taken) {
    const std::uint32_t of_other = s_.operands[1 - several_]->smallest;
    for (std::uint32_t t = 0; t < s_.size; ++t) {
      const SegmentOrigin& o = s_.origin[t];
      if ((o.of_first == several_ ? o.vertex : o.edge) != of_other) continue;
      const std::uint32_t vertex = entry_of_several(t);
      const std::uint32_t ring = marks_.ring_of[vertex];
      if (ring >= marks_.smallest.size() || marks_.smallest[ring] != vertex) continue;
      ++walk_;
      if (!follow({t, {}}, 0, 0, taken)) return false;
    }
    return true;
  }

  /// Returns the edge or the vertex that a segment has of the operand of several polygons.
  [[nodiscard]] std::uint32_t entry_of_several(std::uint32_t segment) const {
    const SegmentOrigin& o = s_.origin[segment];
    return o.of_first == several_ ? o.edge : o.vertex;
  }
  /// Whether the walk goes from one polygon's part of the sum to that of another one, which may
  /// only touch it there. To the walk, the rings of parts that touch are one.
  [[nodiscard, gnu::always_inline]] bool may_touch(const WalkLocation& place,
                                                   const Next& next) const {
    if (!kSeveral) return false;
    const std::uint32_t ring = marks_.ring_of[entry_of_several(place.segment)];
    return ring != marks_.ring_of[entry_of_several(next.place.segment)] &&
           !overlap(place.segment, next);
  }
  [[gnu::always_inline]] void note_touch(const WalkLocation& place, const Next& next) {
    if (!may_touch(place, next)) return;
    boundary_.touching.push_back({next.place.segment, next.place.passed.by});
  }
  /// Whether both parts overlap there: segments cross, or the next one goes on along the same line.
  [[nodiscard, gnu::noinline]] bool overlap(std::uint32_t from, const Next& next) const {
    if (next.turn > 0 || next.place.passed.is_start()) return false;
    if (next.turn == 0) return true;
    const std::uint32_t to = next.place.segment;
    return ways_.end_of(from, to, ways_.start_of(from, to), ways_.turn(to, from)) != 0;
  }

  /// Walks around from a place, to which the walk comes back after a step that is the last, and
  /// keeps the ring if it is one of the boundary: if a point just on its right is outside the sum.
  /// Returns false if that is not known.
  template <class IsLast>
  [[nodiscard, gnu::noinline]] bool add_if_boundary(WalkLocation place, IsLast is_last) {
    const std::uint32_t between_before = boundary_.between;
    const std::size_t touching_before = boundary_.touching.size();
    Piece longest;
    Next next;
    bool done = false;
    do {
      if (boundary_.size == SmallBoundary::kMax) return false;
      corner(place);
      do {
        next = next_of_ring(place);
        note_touch(place, next);
        const Piece piece = piece_between(place, next);
        if (piece.to - piece.from > longest.to - longest.from) longest = piece;
        done = is_last(place.segment, next);
        place = next.place;
      } while (next.turn == 0);
    } while (!done);
    using Result = SmallPlacement::Result;
    const Result result = placement_.test(s_, longest.segment, longest.from, longest.to);
    if (result == Result::kOutside) {
      end_ring();
    } else {
      boundary_.size = boundary_.end_of.back();
      boundary_.between = between_before;
      boundary_.touching.resize(touching_before);
    }
    return result != Result::kUnknown;
  }
  /// The same as next_after, out of line: rings are few.
  [[nodiscard, gnu::noinline]] Next next_of_ring(const WalkLocation& place) {
    return next_after(place);
  }
  /// A part of a segment, between two rounded fractions of its way.
  struct Piece {
    std::uint32_t segment = kNoSegment;
    double from = 0;
    double to = 0;
  };
  [[nodiscard]] Piece piece_between(const WalkLocation& place, const Next& next) const {
    const std::uint32_t at = place.segment;
    const double to =
        next.turn >= 0 ? 1 : ways_.rounded(at, ways_.crossing(at, next.place.segment));
    return {at, ways_.rounded(at, place.passed), to};
  }

  const SmallSegments& s_;
  const SmallMeetings& m_;
  WayFractions<Number> ways_;
  SmallPlacement& placement_;
  WalkMarks& marks_;
  SmallBoundary& boundary_;
  std::size_t several_ = 0;  ///< the operand that has several polygons, by `of_first`
  std::uint32_t walk_ = 1;   ///< the number of the last walk
};

}  // namespace minksum

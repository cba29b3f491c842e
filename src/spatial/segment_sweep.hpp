// Sweeps a line over segments, and leaves out those that cross, so that the others keep their
// order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/sign.hpp"
#include "machine/make_room.hpp"
#include "spatial/sweep_status.hpp"

namespace minksum {

/// Memory of a sweep.
struct SegmentSweepScratch {
  SweepStatus status;
  std::vector<SlotId> slot_of;  ///< by segment
  std::vector<SlotId> at;
  std::vector<std::uint32_t> after;
};

/// Passes points from left to right, and from bottom to top on one vertical, and keeps the segments
/// that the sweep line meets in their order (Shamos, Hoey 1976).
///
/// Neighbours that cross farther to the right are *suspect* and left out, and so are segments that
/// cross at the present point. The segments that stay never cross. So each segment takes O(log n)
/// decisions, however often segments meet. Each suspect is left out beside another one that it
/// meets.
///
/// `Line` knows the segments, and has these members:
/// - low_end(s), high_end(s): a segment's ends, in the order of the sweep;
/// - place(p): a number by which points are in this order, equal for equal points;
/// - side(s, p): the side of a segment on which a point lies, kPositive above;
/// - suspect(s): takes note that a segment is left out; is_suspect(s);
/// - started(s, slot_below): takes note that a segment has got a place.
template <class Line>
class SegmentSweep {
 public:
  static constexpr SlotId kGround = SweepStatus::kGround;
  static constexpr SlotId kNone = SweepStatus::kNone;
  static constexpr std::uint32_t kNoSegment = 0xFFFFFFFFU;

  SegmentSweep(Line& line, Cancellation& cancellation, SegmentSweepScratch& scratch)
      : line_(line), cancellation_(cancellation), s_(scratch) {}

  /// Starts before the first point. The segments are those below `count`.
  void start(std::size_t count) {
    s_.status.clear();
    assign_in_pieces(s_.slot_of, count, kNone, cancellation_);
  }

  [[nodiscard]] const SweepStatus& status() const { return s_.status; }
  /// Returns whether a segment that has started and not ended has a place.
  [[nodiscard]] bool has_place(std::uint32_t segment) const { return s_.slot_of[segment] != kNone; }

  /// Passes a point where one segment with a place ends and another one starts. Does nothing, and
  /// returns false, if a third one passes the point.
  [[nodiscard]] bool go_on(std::uint32_t point, std::uint32_t ending, std::uint32_t starting) {
    const SlotId slot = s_.slot_of[ending];
    under_ = s_.status.below(slot);
    over_ = s_.status.above(slot);
    if (goes_through(under_, point) || goes_through(over_, point)) return false;
    s_.status.set_segment(slot, starting);
    s_.slot_of[starting] = slot;
    part_neighbours();
    return true;
  }
  /// Moves the line to a point. `ending` is some segment with a place that ends there, or
  /// kNoSegment. Returns the only segment that has the point inside. Returns kNoSegment if there is
  /// none; several are suspect.
  [[nodiscard]] std::uint32_t arrive(std::uint32_t point, std::uint32_t ending) {
    cancellation_.check(4);
    under_ = kGround;
    if (ending != kNoSegment) {
      under_ = s_.slot_of[ending];
      while (goes_through(under_, point)) under_ = s_.status.below(under_);
    } else {
      under_ = s_.status.search([&](std::uint32_t s) {
        cancellation_.check(2);
        return line_.side(s, point) == kPositive;
      });
    }
    s_.at.clear();
    over_ = s_.status.above(under_);
    for (; goes_through(over_, point); over_ = s_.status.above(over_)) {
      cancellation_.check();
      s_.at.push_back(over_);
    }
    return passing_at(point);
  }

  /// Moves on. `starting(visit)` calls visit(segment, other end) for the segments that start at the
  /// point, counter-clockwise. No two that are not suspect have one direction, and none has that of
  /// `passing`.
  template <class Starting>
  void leave(std::uint32_t passing, Starting starting) {
    s_.after.clear();
    bool listed = passing == kNoSegment;
    starting([&](std::uint32_t segment, std::uint32_t end) {
      cancellation_.check();
      if (line_.is_suspect(segment)) return;
      if (!listed && line_.side(passing, end) == kPositive) {
        s_.after.push_back(passing);
        listed = true;
      }
      s_.after.push_back(segment);
    });
    if (!listed) s_.after.push_back(passing);
    exchange();
    part_neighbours();
  }

 private:
  [[nodiscard]] bool ends_at(std::uint32_t segment, std::uint32_t point) const {
    return line_.place(line_.high_end(segment)) == line_.place(point);
  }
  [[nodiscard]] bool goes_through(SlotId slot, std::uint32_t point) {
    if (slot == kGround || slot == kNone) return false;
    const std::uint32_t segment = s_.status.segment(slot);
    return ends_at(segment, point) || line_.side(segment, point) == kZero;
  }
  [[nodiscard]] std::uint32_t passing_at(std::uint32_t point) {
    std::uint32_t found = kNoSegment;
    bool several = false;
    for (const SlotId slot : s_.at) {
      const std::uint32_t segment = s_.status.segment(slot);
      if (ends_at(segment, point)) continue;
      if (found != kNoSegment) {
        displace(found);
        displace(segment);
        several = true;
      }
      found = segment;
    }
    return several ? kNoSegment : found;
  }
  void displace(std::uint32_t segment) {
    line_.suspect(segment);
    s_.slot_of[segment] = kNone;
  }

  /// Gives the slots of the segments through the point to those that go on.
  void exchange() {
    std::size_t used = 0;
    SlotId last = under_;
    for (const std::uint32_t segment : s_.after) {
      cancellation_.check(2);
      if (used < s_.at.size()) {
        last = s_.at[used++];
        s_.status.set_segment(last, segment);
      } else {
        last = s_.status.insert_above(last, segment);
      }
      s_.slot_of[segment] = last;
      line_.started(segment, s_.status.below(last));
    }
    cancellation_.check(4 * (s_.at.size() - used));
    while (used < s_.at.size()) s_.status.erase(s_.at[used++]);
  }
  /// Leaves out neighbours around the point that cross farther to the right, until none do.
  void part_neighbours() {
    for (SlotId low = under_; low != over_;) {
      cancellation_.check(2);
      const SlotId high = s_.status.above(low);
      if (low == kGround || high == kNone || !cross(low, high)) {
        low = high;
        continue;
      }
      if (high == over_) over_ = s_.status.above(over_);
      const SlotId below = s_.status.below(low);
      for (const SlotId slot : {low, high}) {
        displace(s_.status.segment(slot));
        s_.status.erase(slot);
      }
      low = below;
    }
  }
  /// Tells whether the segments of two slots, one above the other, change their order.
  [[nodiscard]] bool cross(SlotId low, SlotId high) {
    const std::uint32_t a = s_.status.segment(low);
    const std::uint32_t b = s_.status.segment(high);
    const std::uint32_t a_end = line_.high_end(a);
    const std::uint32_t b_end = line_.high_end(b);
    if (line_.place(a_end) == line_.place(b_end)) return false;
    return line_.place(a_end) < line_.place(b_end) ? line_.side(b, a_end) == kPositive
                                                   : line_.side(a, b_end) == kNegative;
  }

  Line& line_;
  Cancellation& cancellation_;
  SegmentSweepScratch& s_;
  SlotId under_ = kGround;  ///< below the segments through the point
  SlotId over_ = kNone;     ///< above them
};

}  // namespace minksum

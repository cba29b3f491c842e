// Keeps the segments that a sweep line meets, from bottom to top.
#pragma once

#include <cstdint>
#include <vector>

#include "machine/scramble.hpp"

namespace minksum {

using SlotId = std::uint32_t;

/// An ordered list of segments' numbers, with insertion and removal at known places, and search.
/// The list is a treap whose nodes are linked in their order. Priorities are a fixed hash of the
/// slots' numbers. So operations take O(log n) expected time, and are alike in every run.
class SweepStatus {
 public:
  SweepStatus() { clear(); }

  static constexpr SlotId kGround = 0;  ///< below everything, and in no tree
  static constexpr SlotId kNone = 0xFFFFFFFFU;

  /// Forgets all segments, and keeps the memory.
  void clear() {
    slots_.assign(1, {});
    free_.clear();
    root_ = kNone;
  }

  [[nodiscard]] std::uint32_t segment(SlotId slot) const { return slots_[slot].segment; }
  void set_segment(SlotId slot, std::uint32_t segment) { slots_[slot].segment = segment; }
  [[nodiscard]] SlotId below(SlotId slot) const { return slots_[slot].below; }
  [[nodiscard]] SlotId above(SlotId slot) const { return slots_[slot].above; }

  /// Returns the highest slot whose segment `is_below` accepts, or the ground. `is_below` must
  /// accept the segments up to some height, and no others.
  template <class IsBelow>
  [[nodiscard]] SlotId search(IsBelow is_below) const {
    SlotId best = kGround;
    for (SlotId at = root_; at != kNone;) {
      if (is_below(slots_[at].segment)) {
        best = at;
        at = slots_[at].high;
      } else {
        at = slots_[at].low;
      }
    }
    return best;
  }

  /// Inserts a segment right above a slot (or the ground).
  SlotId insert_above(SlotId slot, std::uint32_t segment) {
    const SlotId added = take_slot();
    Slot& own = slots_[added];
    own.segment = segment;
    const SlotId next = slots_[slot].above;
    own.below = slot;
    own.above = next;
    slots_[slot].above = added;
    if (next != kNone) slots_[next].below = added;
    if (root_ == kNone) {
      root_ = added;
      return added;
    }
    // One of the two neighbours has a free side here.
    if (slot != kGround && slots_[slot].high == kNone) {
      slots_[slot].high = added;
      own.parent = slot;
    } else {
      slots_[next].low = added;
      own.parent = next;
    }
    while (slots_[added].parent != kNone &&
           slots_[slots_[added].parent].priority < slots_[added].priority) {
      rotate_up(added);
    }
    return added;
  }

  void erase(SlotId slot) {
    while (slots_[slot].low != kNone || slots_[slot].high != kNone) {
      const SlotId low = slots_[slot].low;
      const SlotId high = slots_[slot].high;
      const bool take_low =
          high == kNone || (low != kNone && slots_[low].priority > slots_[high].priority);
      rotate_up(take_low ? low : high);
    }
    replace_child(slots_[slot].parent, slot, kNone);
    const SlotId below = slots_[slot].below;
    const SlotId above = slots_[slot].above;
    slots_[below].above = above;
    if (above != kNone) slots_[above].below = below;
    free_.push_back(slot);
  }

 private:
  struct Slot {
    std::uint32_t segment = kNone;
    SlotId parent = kNone;
    SlotId low = kNone;
    SlotId high = kNone;
    SlotId below = kNone;
    SlotId above = kNone;
    std::uint32_t priority = 0;
  };

  SlotId take_slot() {
    if (!free_.empty()) {
      const SlotId slot = free_.back();
      free_.pop_back();
      const std::uint32_t priority = slots_[slot].priority;
      slots_[slot] = {};
      slots_[slot].priority = priority;
      return slot;
    }
    slots_.emplace_back();
    const auto slot = static_cast<SlotId>(slots_.size() - 1);
    slots_[slot].priority = scramble(slot);
    return slot;
  }
  void replace_child(SlotId parent, SlotId child, SlotId by) {
    if (parent == kNone) {
      root_ = by;
    } else if (slots_[parent].low == child) {
      slots_[parent].low = by;
    } else {
      slots_[parent].high = by;
    }
    if (by != kNone) slots_[by].parent = parent;
  }
  /// Lets a slot and its parent change places.
  void rotate_up(SlotId slot) {
    const SlotId parent = slots_[slot].parent;
    replace_child(slots_[parent].parent, parent, slot);
    const bool was_low = slots_[parent].low == slot;
    const SlotId inner = was_low ? slots_[slot].high : slots_[slot].low;
    (was_low ? slots_[parent].low : slots_[parent].high) = inner;
    if (inner != kNone) slots_[inner].parent = parent;
    (was_low ? slots_[slot].high : slots_[slot].low) = parent;
    slots_[parent].parent = slot;
  }

  std::vector<Slot> slots_;
  std::vector<SlotId> free_;
  SlotId root_ = kNone;
};

}  // namespace minksum

#include "validation/misplaced_rings.hpp"

#include <algorithm>

#include "machine/make_room.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {
namespace {

/// Walks through the tree of rings, and keeps count of the rings around the present one.
class Walk {
 public:
  Walk(std::span<const OperandRing> rings, std::span<const std::uint32_t> parent,
       Cancellation& cancellation, RingNesting& nesting)
      : rings_(rings), s_(nesting) {
    s_.polygons.assign(rings.back().polygon + std::size_t{1}, {});
    s_.misplaced.assign(rings.size(), {});
    list_inner(parent, cancellation);
    // A ring is entered when it is met first, and left when all rings in it have been.
    std::uint32_t at = root();
    s_.next.assign(s_.first_inner.begin(), s_.first_inner.end() - 1);
    for (;;) {
      cancellation.check(4);
      if (s_.next[at] < s_.first_inner[at + 1]) {
        at = s_.inner[s_.next[at]++];
        enter(at);
      } else if (at == root()) {
        break;
      } else {
        leave(at);
        at = parent_of(parent, at);
      }
    }
  }

 private:
  using Around = RingNesting::Around;

  [[nodiscard]] std::uint32_t root() const { return static_cast<std::uint32_t>(rings_.size()); }
  [[nodiscard]] std::uint32_t parent_of(std::span<const std::uint32_t> parent,
                                        std::uint32_t ring) const {
    return std::min(parent[ring], root());
  }
  /// Lists the rings directly inside of each ring.
  void list_inner(std::span<const std::uint32_t> parent, Cancellation& cancellation) {
    list_by_key(rings_.size() + 1, cancellation, s_.first_inner, s_.inner, [&](auto visit) {
      for (std::uint32_t r = 0; r < root(); ++r) {
        cancellation.check();
        visit(parent_of(parent, r), r);
      }
    });
  }
  void enter(std::uint32_t r) {
    const OperandRing& ring = rings_[r];
    Around& own = s_.polygons[ring.polygon];
    if (ring.is_hole()) {
      s_.misplaced[r] = {own.holes != 0, !own.outer, false};
    } else {
      s_.misplaced[r].in_other_outer = inside_ != 0;
    }
    inside_ -= own.is_inside() ? 1U : 0U;
    ring.is_hole() ? static_cast<void>(++own.holes) : static_cast<void>(own.outer = true);
    inside_ += own.is_inside() ? 1U : 0U;
  }
  void leave(std::uint32_t r) {
    const OperandRing& ring = rings_[r];
    Around& own = s_.polygons[ring.polygon];
    inside_ -= own.is_inside() ? 1U : 0U;
    ring.is_hole() ? static_cast<void>(--own.holes) : static_cast<void>(own.outer = false);
    inside_ += own.is_inside() ? 1U : 0U;
  }

  std::span<const OperandRing> rings_;
  RingNesting& s_;
  std::size_t inside_ = 0;  // polygons that have the present place inside
};

}  // namespace

void find_misplaced_rings(std::span<const OperandRing> rings, std::span<const std::uint32_t> parent,
                          Cancellation& cancellation, RingNesting& nesting) {
  if (!rings.empty()) Walk(rings, parent, cancellation, nesting);
}

}  // namespace minksum

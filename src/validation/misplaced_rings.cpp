#include "validation/misplaced_rings.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "machine/make_room.hpp"

namespace minksum {
namespace {

/// Walks through the tree of rings, and keeps count of the rings around the present one.
class Walk {
 public:
  Walk(std::span<const OperandRing> rings, std::span<const std::uint32_t> parent,
       Cancellation& cancellation)
      : rings_(rings), polygons_(rings.back().polygon + std::size_t{1}), misplaced_(rings.size()) {
    list_inner(parent, cancellation);
    // A ring is entered when it is met first, and left when all rings in it have been.
    std::uint32_t at = root();
    std::vector<std::uint32_t> next(first_inner_.begin(), first_inner_.end() - 1);
    for (;;) {
      cancellation.check(4);
      if (next[at] < first_inner_[at + 1]) {
        at = inner_[next[at]++];
        enter(at);
      } else if (at == root()) {
        break;
      } else {
        leave(at);
        at = parent_of(parent, at);
      }
    }
  }

  [[nodiscard]] std::vector<Misplacement> take() { return std::move(misplaced_); }

 private:
  /// The rings of a polygon that lie around the present ring.
  struct Around {
    bool outer = false;
    std::uint32_t holes = 0;
    [[nodiscard]] bool is_inside() const { return outer && holes == 0; }
  };

  [[nodiscard]] std::uint32_t root() const { return static_cast<std::uint32_t>(rings_.size()); }
  [[nodiscard]] std::uint32_t parent_of(std::span<const std::uint32_t> parent,
                                        std::uint32_t ring) const {
    return std::min(parent[ring], root());
  }
  /// Lists the rings directly inside of each ring.
  void list_inner(std::span<const std::uint32_t> parent, Cancellation& cancellation) {
    assign_in_pieces(first_inner_, rings_.size() + 3, 0U, cancellation);
    for (std::uint32_t r = 0; r < root(); ++r) {
      cancellation.check();
      ++first_inner_[parent_of(parent, r) + 2];
    }
    std::partial_sum(first_inner_.begin(), first_inner_.end(), first_inner_.begin());
    resize_in_pieces(inner_, rings_.size(), cancellation);
    for (std::uint32_t r = 0; r < root(); ++r) {
      cancellation.check();
      inner_[first_inner_[parent_of(parent, r) + 1]++] = r;
    }
    first_inner_.pop_back();
  }
  void enter(std::uint32_t r) {
    const OperandRing& ring = rings_[r];
    Around& own = polygons_[ring.polygon];
    if (ring.is_hole()) {
      misplaced_[r] = {own.holes != 0, !own.outer, false};
    } else {
      misplaced_[r].in_other_outer = inside_ != 0;
    }
    inside_ -= own.is_inside() ? 1U : 0U;
    ring.is_hole() ? static_cast<void>(++own.holes) : static_cast<void>(own.outer = true);
    inside_ += own.is_inside() ? 1U : 0U;
  }
  void leave(std::uint32_t r) {
    const OperandRing& ring = rings_[r];
    Around& own = polygons_[ring.polygon];
    inside_ -= own.is_inside() ? 1U : 0U;
    ring.is_hole() ? static_cast<void>(--own.holes) : static_cast<void>(own.outer = false);
    inside_ += own.is_inside() ? 1U : 0U;
  }

  std::span<const OperandRing> rings_;
  std::vector<Around> polygons_;            // by polygon
  std::vector<Misplacement> misplaced_;     // by ring
  std::vector<std::uint32_t> first_inner_;  // by ring, and then the root: where its rings begin
  std::vector<std::uint32_t> inner_;
  std::size_t inside_ = 0;  // polygons that have the present place inside
};

}  // namespace

std::vector<Misplacement> misplaced_rings(std::span<const OperandRing> rings,
                                          std::span<const std::uint32_t> parent,
                                          Cancellation& cancellation) {
  if (rings.empty()) return {};
  return Walk(rings, parent, cancellation).take();
}

}  // namespace minksum

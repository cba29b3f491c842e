// Tells whether a small operand is clearly valid.
#include <algorithm>
#include <span>

#include "machine/vectors.hpp"
#include "sum/small/small_operand.hpp"
#include "sum/small/small_rings.hpp"

namespace minksum {
namespace {

template <class Number>
bool is_simple_ring(const SmallOperand& s) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return is_simple<Number>(s); });
}
template <class Number>
bool do_rings_meet(const SmallOperand& a, const SmallOperand& b) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return do_meet<Number>(a, b); });
}

/// Whether a hole is simple and lies inside the outer ring, apart from the holes before it.
template <class Number>
bool is_clear_hole(const SmallOperand& hole, const SmallOperand& outer,
                   std::span<const SmallOperand> before, std::span<const BoxOf<double>> boxes) {
  const BoxOf<double>& box = boxes[before.size()];
  if (box.x0 < 0 || box.y0 < 0 || box.x1 > outer.extent.x || box.y1 > outer.extent.y ||
      !is_simple_ring<Number>(hole) || !holds<Number>(outer, hole) ||
      do_rings_meet<Number>(hole, outer)) {
    return false;
  }
  for (std::size_t l = 0; l < before.size(); ++l) {
    if (box.meets(boxes[l]) && (do_rings_meet<Number>(hole, before[l]) ||
                                holds<Number>(hole, before[l]) || holds<Number>(before[l], hole))) {
      return false;
    }
  }
  return true;
}

/// Returns false if a hole is not clearly valid, or if two rings touch.
bool are_holes_clearly_valid(const Region& region, SmallHoles& holes, SmallOperand& s) {
  const std::size_t count = s.holes.size();
  if (holes.rings.size() < count) holes.rings.resize(count);
  holes.boxes.clear();
  for (std::size_t k = 0; k < count; ++k) {
    SmallOperand& hole = holes.rings[k];
    if (!load_hole(region, k + 1, s, hole)) return false;
    holes.boxes.push_back(box_of(hole));
    const SmallNumberType numbers =
        small_numbers(std::max(s.longest, hole.longest), std::max(s.extent.x, s.extent.y));
    const auto is_clear = [&]<class Number>() {
      return is_clear_hole<Number>(hole, s, std::span(holes.rings).first(k), holes.boxes);
    };
    if (numbers == SmallNumberType::kNone || !with_numbers(numbers, is_clear)) return false;
  }
  for (std::size_t k = 0; k < count; ++k) add_hole(holes.rings[k], s);
  return true;
}

}  // namespace

bool is_clearly_valid(const Region& region, SmallHoles& holes, SmallOperand& s) {
  const auto numbers = small_numbers(s.longest, std::max(s.extent.x, s.extent.y));
  const auto is_simple = [&]<class Number>() { return is_simple_ring<Number>(s); };
  // A ring that turns left everywhere, and goes round once, is simple.
  const bool goes_round_once = s.convex && s.turning == 1;
  return (goes_round_once || with_numbers(numbers, is_simple)) &&
         are_holes_clearly_valid(region, holes, s);
}

bool read_small(const Region& region, SmallHoles& holes, SmallOperand& small) {
  return load_small(region, small) && is_clearly_valid(region, holes, small);
}

}  // namespace minksum

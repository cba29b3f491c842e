// Tells whether a small operand is clearly valid.
#include <algorithm>
#include <span>

#include "machine/vectors.hpp"
#include "sum/small/small_operand.hpp"
#include "sum/small/small_rings.hpp"

namespace minksum {
namespace {

template <class Number>
bool is_simple_ring(const SmallNumbers<Number>& numbers, const SmallEdges& edges) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) { return is_simple(numbers, edges); });
}
template <class Number>
bool may_rings_meet(const SmallNumbers<Number>& numbers, const SmallEdges& edges,
                    const SmallEdges& others) {
  return with_vectors(
      widest_vectors(), [&]() __attribute__((always_inline)) {
        return may_meet(numbers, edges, others);
      });
}

/// Whether a hole is simple and lies inside the outer ring, apart from the holes before it.
template <class Number>
bool is_clear_hole(const SmallNumbers<Number>& numbers, const SmallOperand& hole,
                   const SmallOperand& outer, const SmallEdges& outer_edges,
                   std::span<const SmallOperand> before, std::span<const BoxOf<double>> boxes) {
  const BoxOf<double>& box = boxes[before.size()];
  if (box.x0 < 0 || box.y0 < 0 || box.x1 > outer.extent.x || box.y1 > outer.extent.y) return false;
  const SmallEdges edges(hole, hole.size, numbers.reach);
  if (!is_simple_ring(numbers, edges) || may_rings_meet(numbers, edges, outer_edges) ||
      !holds(numbers, outer, hole)) {
    return false;
  }
  for (std::size_t l = 0; l < before.size(); ++l) {
    if (box.meets(boxes[l]) &&
        (may_rings_meet(numbers, edges, SmallEdges(before[l], before[l].size, numbers.reach)) ||
         holds(numbers, hole, before[l]) || holds(numbers, before[l], hole))) {
      return false;
    }
  }
  return true;
}

/// Calls work(numbers) for the numbers of an operand's ring.
template <class Work>
auto with_numbers_of(const SmallOperand& s, const SmallOperand& ring, Work work) {
  const double width = std::max(s.extent.x, s.extent.y);
  const SmallNumberType type = small_numbers(s.is_wide(), std::max(s.longest, ring.longest), width);
  return with_numbers(type, width, work);
}

/// Returns false if a hole is not clearly valid, or if two rings touch.
bool are_holes_clearly_valid(const Region& region, SmallHoles& holes, SmallOperand& s) {
  const std::size_t count = s.holes.size();
  if (holes.rings.size() < count) holes.rings.resize(count);
  holes.boxes.clear();
  const SmallEdges outer = with_numbers_of(
      s, s, [&](const auto& numbers) { return SmallEdges(s, s.size, numbers.reach); });
  for (std::size_t k = 0; k < count; ++k) {
    SmallOperand& hole = holes.rings[k];
    if (!load_hole(region, k + 1, s, hole)) return false;
    holes.boxes.push_back(box_of(hole));
    const auto is_clear = [&](const auto& numbers) {
      return is_clear_hole(numbers, hole, s, outer, std::span(holes.rings).first(k), holes.boxes);
    };
    if (!with_numbers_of(s, hole, is_clear)) return false;
  }
  for (std::size_t k = 0; k < count; ++k) add_hole(holes.rings[k], s);
  return true;
}

}  // namespace

bool is_clearly_valid(const Region& region, SmallHoles& holes, SmallOperand& s) {
  const auto is_simple = [&](const auto& numbers) {
    return is_simple_ring(numbers, SmallEdges(s, s.size, numbers.reach));
  };
  // A ring that turns left everywhere, and goes round once, is simple. Rounded edges may make it
  // seem to go round more often, but not less.
  const bool goes_round_once = s.convex && s.turning == 1;
  if (!goes_round_once && !with_numbers_of(s, s, is_simple)) return false;
  return s.holes.empty() || are_holes_clearly_valid(region, holes, s);
}

bool read_small(const Region& region, SmallHoles& holes, SmallOperand& small) {
  return load_small(region, small) && is_clearly_valid(region, holes, small);
}

}  // namespace minksum

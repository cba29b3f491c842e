// Turns small operands, and brings them to finer grids.
#include <algorithm>
#include <utility>

#include "sum/small/small_grid.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  to = from;
  const std::size_t entries = filled_up(to.entries);
  const bool rounded = to.is_wide() || to.steps != 1;
  using Rows = std::pair<SmallOperand::Row, SmallOperand::Row>;
  for (int k = 0; k < turns; ++k) {
    for (const auto& [row_x, row_y] :
         {Rows{SmallOperand::kX, SmallOperand::kY}, Rows{SmallOperand::kDx, SmallOperand::kDy},
          Rows{SmallOperand::kInX, SmallOperand::kInY},
          Rows{SmallOperand::kOutX, SmallOperand::kOutY}}) {
      double* const x = to[row_x];
      double* const y = to[row_y];
      if (rounded && row_x == SmallOperand::kX) {
        // The difference of two rounded numbers would be off by more than a rounded one.
        if (to.is_long()) {
          to.turn_long();
          continue;
        }
        for (std::size_t i = 0; i < entries; ++i) {
          const Vec<Int128> before = to.whole_at(i);
          const Vec<Int128> at{to.whole_extent.y - before.y, before.x};
          if (to.is_wide()) to.whole()[i] = at;
          x[i] = static_cast<double>(at.x) * static_cast<double>(to.steps);
          y[i] = static_cast<double>(at.y) * static_cast<double>(to.steps);
        }
        continue;
      }
      const double width = row_x == SmallOperand::kX ? to.extent.y : 0;
      for (std::size_t i = 0; i < entries; ++i) {
        const double before = std::exchange(y[i], x[i]);
        x[i] = width - before;
      }
    }
    std::swap(to.extent.x, to.extent.y);
    std::swap(to.least_extent.x, to.least_extent.y);
    std::swap(to.whole_extent.x, to.whole_extent.y);
    for (Vec<double>& hole : to.holes) std::swap(hole.x, hole.y);
    to.offset = {-(to.offset.y + to.whole_extent.x), to.offset.x};
  }
  find_smallest(to);
}

Refinement finer_grid(int exp2, int exp10, const SmallOperand& s) {
  const int tens = s.exp10 - exp10;
  const int twos = s.exp2 - exp2;
  const double width = std::max(s.extent.x, s.extent.y);
  if (!s.is_wide()) {
    std::int64_t steps = 1;
    auto x = static_cast<std::int64_t>(s.offset.x);
    auto y = static_cast<std::int64_t>(s.offset.y);
    if (scale(tens, twos, steps) && scale(tens, twos, x) && scale(tens, twos, y) &&
        static_cast<double>(steps) * width <= SmallOperand::kWidest) {
      return {static_cast<double>(steps), false};
    }
  }
  Int128 steps = 1;
  const double farthest = s.is_long() ? s.long_reach() : width;
  const bool fit = scale(tens, twos, steps) &&
                   static_cast<double>(steps) * farthest <= SmallOperand::kWidestFine;
  return fit ? Refinement{static_cast<double>(steps), true} : Refinement{};
}

void refine(int exp2, int exp10, std::uint32_t entries, const SmallOperand& from,
            SmallOperand& to) {
  const Refinement by = finer_grid(exp2, exp10, from);
  Int128 factor = 1;
  static_cast<void>(scale(from.exp10 - exp10, from.exp2 - exp2, factor));
  const std::size_t room = filled_up(entries);
  if (&to != &from) {
    to.size = from.size;
    to.outer_rings = from.outer_rings;
    to.smallest = from.smallest;
    to.convex = from.convex;
    to.turning = from.turning;
    to.turning_of_holes = from.turning_of_holes;
    to.holes = from.holes;
    to.ends = from.ends;
    to.first = from.first;
    to.make_rows(room, from.is_wide(), from.is_long());
    std::copy_n(from.whole().begin(), to.whole().size(), to.whole().begin());
    if (from.is_long()) to.copy_long(from);
    for (const auto row : {SmallOperand::kVertexSource, SmallOperand::kEdgeSource}) {
      std::copy_n(from[row], room, to[row]);
    }
  }
  to.set_multiples(from, room, by.steps);
  for (Vec<double>& hole : to.holes) hole = {hole.x * by.steps, hole.y * by.steps};
  to.longest = from.longest * by.steps;
  to.extent = {from.extent.x * by.steps, from.extent.y * by.steps};
  to.least_extent = {from.least_extent.x * by.steps, from.least_extent.y * by.steps};
  const Int128 of_unit = by.rounded ? 1 : factor;
  to.whole_extent = {from.whole_extent.x * of_unit, from.whole_extent.y * of_unit};
  to.offset = {from.offset.x * of_unit, from.offset.y * of_unit};
  to.steps = by.rounded ? factor : 1;
  to.units = by.rounded ? 1 / by.steps : 1;
  to.entries = entries;
  to.exp2 = exp2;
  to.exp10 = exp10;
}

}  // namespace minksum

// Turns small operands, and brings them to finer grids.
#include <algorithm>
#include <array>
#include <utility>

#include "sum/small/small_grid.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {
namespace {

/// Sets the rows of a wide operand to multiples of those of another one, which may be the same, and
/// may not have been wide.
void multiply_wide(const SmallOperand& from, bool was_wide, std::size_t count, Int128 factor,
                   SmallOperand& to) {
  using Row = SmallOperand::Row;
  struct Rows {
    SmallOperand::WholeRow whole;
    Row x;
    Row y;
  };
  constexpr std::array<Rows, SmallOperand::kWholeRows> kAll{
      {{SmallOperand::kAt, SmallOperand::kX, SmallOperand::kY},
       {SmallOperand::kWay, SmallOperand::kDx, SmallOperand::kDy},
       {SmallOperand::kIn, SmallOperand::kInX, SmallOperand::kInY}}};
  for (std::size_t i = 0; i < count; ++i) {
    const bool convex = from[SmallOperand::kInX][i] != 0 || from[SmallOperand::kInY][i] != 0;
    for (const Rows& rows : kAll) {
      const Vec<Int128> before = was_wide ? from.whole(rows.whole)[i]
                                          : Vec<Int128>{static_cast<std::int64_t>(from[rows.x][i]),
                                                        static_cast<std::int64_t>(from[rows.y][i])};
      const Vec<Int128> whole{before.x * factor, before.y * factor};
      const Vec<double> near = rounded(whole);
      to.whole(rows.whole)[i] = whole;
      const auto set = [&](Row x, Row y, bool is_set) {
        to[x][i] = is_set ? near.x : 0;
        to[y][i] = is_set ? near.y : 0;
      };
      set(rows.x, rows.y, rows.whole != SmallOperand::kIn || convex);
      if (rows.whole == SmallOperand::kWay) set(SmallOperand::kOutX, SmallOperand::kOutY, convex);
    }
  }
}

}  // namespace

void turn(const SmallOperand& from, int quarters, SmallOperand& to) {
  const int turns = ((quarters % 4) + 4) % 4;
  to = from;
  const std::size_t entries = filled_up(to.entries);
  using Rows = std::pair<SmallOperand::Row, SmallOperand::Row>;
  for (int k = 0; k < turns; ++k) {
    for (const auto& [row_x, row_y] :
         {Rows{SmallOperand::kX, SmallOperand::kY}, Rows{SmallOperand::kDx, SmallOperand::kDy},
          Rows{SmallOperand::kInX, SmallOperand::kInY},
          Rows{SmallOperand::kOutX, SmallOperand::kOutY}}) {
      const double width = row_x == SmallOperand::kX ? to.extent.y : 0;
      double* const x = to[row_x];
      double* const y = to[row_y];
      for (std::size_t i = 0; i < entries; ++i) {
        const double before = std::exchange(y[i], x[i]);
        x[i] = width - before;
      }
    }
    for (int row = 0; to.is_wide() && row < SmallOperand::kWholeRows; ++row) {
      const Int128 width = row == SmallOperand::kAt ? to.whole_extent.y : 0;
      Vec<Int128>* const whole = to.whole(static_cast<SmallOperand::WholeRow>(row));
      for (std::size_t i = 0; i < entries; ++i) whole[i] = {width - whole[i].y, whole[i].x};
    }
    std::swap(to.extent.x, to.extent.y);
    std::swap(to.whole_extent.x, to.whole_extent.y);
    for (Vec<double>& hole : to.holes) std::swap(hole.x, hole.y);
    to.offset = {-(to.offset.y + to.whole_extent.x), to.offset.x};
  }
  if (to.is_wide()) {
    // The difference of two rounded numbers is off by more than a rounded one.
    for (std::size_t i = 0; i < entries; ++i) {
      const Vec<double> at = rounded(to.whole(SmallOperand::kAt)[i]);
      to[SmallOperand::kX][i] = at.x;
      to[SmallOperand::kY][i] = at.y;
    }
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
  Vec<Int128> offset = s.offset;
  const bool fit = scale(tens, twos, steps) && scale(tens, twos, offset.x) &&
                   scale(tens, twos, offset.y) &&
                   static_cast<double>(steps) * width <= SmallOperand::kWidestWide;
  return fit ? Refinement{static_cast<double>(steps), true} : Refinement{};
}

void refine(int exp2, int exp10, bool wide, std::uint32_t entries, const SmallOperand& from,
            SmallOperand& to) {
  const int tens = from.exp10 - exp10;
  const int twos = from.exp2 - exp2;
  std::int64_t few = 1;
  Int128 factor = 1;
  if (wide) {
    static_cast<void>(scale(tens, twos, factor));
  } else {
    static_cast<void>(scale(tens, twos, few));
    factor = few;
  }
  const double steps = wide ? static_cast<double>(factor) : static_cast<double>(few);
  const std::size_t room = filled_up(entries);
  const bool was_wide = from.is_wide();
  if (&to != &from) {
    to.size = from.size;
    to.smallest = from.smallest;
    to.convex = from.convex;
    to.turning = from.turning;
    to.turning_of_holes = from.turning_of_holes;
    to.holes = from.holes;
    to.ends = from.ends;
    to.first = from.first;
  }
  for (Vec<double>& hole : to.holes) hole = {hole.x * steps, hole.y * steps};
  to.longest = from.longest * steps;
  to.whole_extent = {from.whole_extent.x * factor, from.whole_extent.y * factor};
  to.extent =
      wide ? rounded(to.whole_extent) : Vec<double>{from.extent.x * steps, from.extent.y * steps};
  to.offset = {from.offset.x * factor, from.offset.y * factor};
  to.entries = entries;
  to.exp2 = exp2;
  to.exp10 = exp10;
  if (&to != &from) to.make_rows(room, wide);
  if (wide) {
    if (!was_wide) to.make_wide();
    multiply_wide(from, was_wide, room, factor, to);
  }
  if (!wide) to.set_multiples(from, room, steps);
  for (const auto row : {SmallOperand::kVertexSource, SmallOperand::kEdgeSource}) {
    if (&to != &from) std::copy_n(from[row], room, to[row]);
  }
}

}  // namespace minksum

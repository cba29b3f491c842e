// Tests whether small rings are simple, meet, or hold each other.
#pragma once

#include <algorithm>
#include <cmath>

#include "sum/small/blocks.hpp"
#include "sum/small/sides.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// Returns those of up to 64 edges of a ring, from `first` on, that edge i of another one meets.
template <class Number>
[[gnu::always_inline]] inline LaneBits edges_meeting(const SmallRows& ring, std::uint32_t i,
                                                     const SmallRows& others, std::size_t first,
                                                     std::size_t count) {
  const Vec<double> at{ring.x[i], ring.y[i]};
  const Vec<double> way{ring.dx[i], ring.dy[i]};
  const auto meets = [&](const auto& cross, std::size_t lane) __attribute__((always_inline)) {
    const std::size_t e = first + lane;
    const Vec<double> a{others.x[e] - at.x, others.y[e] - at.y};
    const Vec<double> t{others.dx[e], others.dy[e]};
    const auto [start, end, along, left] = sides(cross, way, a, t);
    // Edges meet if neither lies on one side of the other's line, and if their boxes meet.
    const bool meet = !((start > 0) & (end > 0)) & !((start < 0) & (end < 0)) &
                      !((along > 0) & (left < 0)) & !((along < 0) & (left > 0)) &
                      (std::abs(2 * a.x + t.x - way.x) <= std::abs(way.x) + std::abs(t.x)) &
                      (std::abs(2 * a.y + t.y - way.y) <= std::abs(way.y) + std::abs(t.y));
    return meet ? kBitOf[lane] : 0;
  };
  return test_lanes<Number>(count / kLanes * kLanes, meets);
}

/// Whether no edge has a point in common with another one, but for the vertex between neighbours.
template <class Number>
[[gnu::always_inline]] inline bool is_simple(const SmallOperand& s) {
  const std::uint32_t n = s.size;
  const SmallRows rows(s);
  // Two blocks are compared in less time than their boxes take.
  const bool few = n <= 2 * kLanes;
  SmallBlocks<SmallOperand::kMaxVertices / kLanes> blocks;
  if (!few) blocks.set(rows.x, rows.y, rows.dx, rows.dy, n);
  LaneBits met = 0;
  for (std::uint32_t i = 0; i < n && met == 0; ++i) {
    // Each edge is compared with those of its own block and of later ones.
    const LaneBits near =
        few ? first_bits(filled_up(n) / kLanes)
            : blocks.near(blocks.box(rows.x[i], rows.y[i], rows.dx[i], rows.dy[i]), 0);
    for_each_bit(
        near & ~first_bits(i / kLanes), [&](std::uint32_t block) __attribute__((always_inline)) {
          const std::uint32_t first = block * kLanes;
          const auto bit = [first](std::uint32_t edge) {
            return edge - first < kLanes ? kBitOf[edge - first] : LaneBits{0};
          };
          met |= edges_meeting<Number>(rows, i, rows, first, kLanes) & first_bits(n - first) &
                 ~(bit(i) | bit(i + 1 == n ? 0 : i + 1) | bit(i == 0 ? n - 1 : i - 1));
        });
  }
  return met == 0;
}

/// Calls visit(i, j) for the edges i of one operand and j of another one that have a point in
/// common, as long as it returns true. The edges are the first `of_a` and `of_b` entries.
template <class Number, class Visit>
[[gnu::always_inline]] inline void for_each_meeting(const SmallOperand& a, std::uint32_t of_a,
                                                    const SmallOperand& b, std::uint32_t of_b,
                                                    Visit visit) {
  const SmallRows edges(a);
  const SmallRows others(b);
  SmallBlocks<SmallOperand::kMaxEntries / kLanes> blocks;
  blocks.set(others.x, others.y, others.dx, others.dy, of_b);
  bool goes_on = true;
  for (std::uint32_t i = 0; i < of_a && goes_on; ++i) {
    const auto box = blocks.box(edges.x[i], edges.y[i], edges.dx[i], edges.dy[i]);
    for_each_bit(
        blocks.near(box, 0), [&](std::uint32_t block) __attribute__((always_inline)) {
          const std::uint32_t first = block * kLanes;
          const LaneBits met =
              edges_meeting<Number>(edges, i, others, first, kLanes) & first_bits(of_b - first);
          for_each_bit(met,
                       [&](std::uint32_t lane) { goes_on = goes_on && visit(i, first + lane); });
        });
  }
}
/// Whether two rings have a point of their boundaries in common.
template <class Number>
[[nodiscard, gnu::always_inline]] inline bool do_meet(const SmallOperand& a,
                                                      const SmallOperand& b) {
  bool meet = false;
  for_each_meeting<Number>(a, a.size, b, b.size, [&](std::uint32_t, std::uint32_t) {
    meet = true;
    return false;
  });
  return meet;
}

/// Whether a ring of any orientation holds the first vertex of another one. The rings must not
/// meet.
template <class Number>
[[nodiscard]] inline bool holds(const SmallOperand& a, const SmallOperand& b) {
  const Vec<double> at{b[SmallOperand::kX][0], b[SmallOperand::kY][0]};
  bool inside = false;
  for (std::uint32_t i = 0; i < a.size; ++i) {
    const Vec<double> d{a[SmallOperand::kDx][i], a[SmallOperand::kDy][i]};
    const Vec<double> to{at.x - a[SmallOperand::kX][i], at.y - a[SmallOperand::kY][i]};
    // This counts edges that pass the height of the point, on its right.
    const bool up = to.y >= 0 && to.y < d.y;
    const bool down = to.y < 0 && to.y >= d.y;
    if (!up && !down) continue;
    const Number side = cross(whole_numbers<Number>(d), whole_numbers<Number>(to));
    if ((up && side > 0) || (down && side < 0)) inside = !inside;
  }
  return inside;
}

/// Returns the box of a ring.
[[nodiscard]] inline BoxOf<double> box_of(const SmallOperand& s) {
  const double* const x = s[SmallOperand::kX];
  const double* const y = s[SmallOperand::kY];
  const auto [x0, x1] = std::minmax_element(x, x + s.size);
  const auto [y0, y1] = std::minmax_element(y, y + s.size);
  return {*x0, *y0, *x1, *y1};
}

}  // namespace minksum

// Tests whether small rings are simple, meet, or hold each other.
#pragma once

#include <algorithm>
#include <cmath>

#include "sum/small/blocks.hpp"
#include "sum/small/sides.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// Returns those of eight edges of a ring, from `first` on, that edge i of another one meets.
template <class Number>
[[gnu::always_inline]] inline LaneBits edges_meeting(const SmallRows& ring, std::uint32_t i,
                                                     const SmallRows& others, std::size_t first) {
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
  return test_lanes<Number>(kLanes, meets);
}

/// The edges of a ring or of all rings of an operand, in blocks of eight.
struct SmallEdges {
  SmallRows rows;
  std::uint32_t size;
  SmallBlocks<SmallOperand::kMaxEntries / kLanes> blocks;

  [[gnu::always_inline]] SmallEdges(const SmallOperand& s, std::uint32_t edges)
      : rows(s), size(edges) {
    blocks.set(rows.x, rows.y, rows.dx, rows.dy, size);
  }
  /// Returns those of a block's eight entries that are edges.
  [[nodiscard]] LaneBits lanes_of(std::size_t block) const {
    return first_bits(std::min<std::size_t>(size - block * kLanes, kLanes));
  }
  /// Returns those of a block's edges whose boxes meet `box`.
  [[nodiscard, gnu::always_inline]] LaneBits near(std::size_t block,
                                                  const BoxOf<double>& box) const {
    const std::size_t i = block * kLanes;
    return segments_near(rows.x + i, rows.y + i, rows.dx + i, rows.dy + i, box) & lanes_of(block);
  }
  /// Whether each of a block's edges leads forward, as seen along the way from the first one's
  /// start to the last one's end. Then they meet at common vertices only. Rounding keeps the order
  /// of the two products, so a sum that comes out positive is positive.
  [[nodiscard, gnu::always_inline]] bool lead_forward(std::size_t block) const {
    const std::size_t first = block * kLanes;
    const std::size_t last = std::min<std::size_t>(first + kLanes, size) - 1;
    const Vec<double> way{rows.x[last] + rows.dx[last] - rows.x[first],
                          rows.y[last] + rows.dy[last] - rows.y[first]};
    LaneBits bits = 0;
    for (std::size_t t = 0; t < kLanes; ++t) {
      const std::size_t e = first + t;
      bits |= rows.dx[e] * way.x + rows.dy[e] * way.y > 0 ? kBitOf[t] : 0;
    }
    return (~bits & lanes_of(block)) == 0;
  }
};

/// Whether no edge has a point in common with another one, but for the vertex between neighbours.
template <class Number>
[[gnu::always_inline]] inline bool is_simple(const SmallOperand& s) {
  const std::uint32_t n = s.size;
  const SmallEdges edges(s, n);
  const auto meet = [&](std::size_t block, LaneBits lanes, std::size_t other)
      __attribute__((always_inline)) {
    LaneBits met = 0;
    const auto first = static_cast<std::uint32_t>(other * kLanes);
    const auto bit = [first](std::uint32_t edge) {
      return edge - first < kLanes ? kBitOf[edge - first] : LaneBits{0};
    };
    for_each_bit(
        lanes, [&](std::uint32_t lane) __attribute__((always_inline)) {
          const auto i = static_cast<std::uint32_t>(block * kLanes) + lane;
          met |= edges_meeting<Number>(edges.rows, i, edges.rows, first) &
                 ~(bit(i) | bit(i + 1 == n ? 0 : i + 1) | bit(i == 0 ? n - 1 : i - 1));
        });
    return (met & edges.lanes_of(other)) != 0;
  };
  for (std::size_t block = 0; block < edges.blocks.size; ++block) {
    if (!edges.lead_forward(block) && meet(block, edges.lanes_of(block), block)) return false;
    for (std::size_t word = block / kLanes * kLanes; word < edges.blocks.size; word += 64) {
      for (LaneBits near = edges.blocks.near_from(block, word); near != 0; near &= near - 1) {
        const std::size_t other = word + static_cast<std::size_t>(std::countr_zero(near));
        if (other == block) continue;
        if (meet(block, edges.near(block, edges.blocks.box_of(other)), other)) return false;
      }
    }
  }
  return true;
}

/// Calls visit(i, first) for the edges i of one operand and the blocks of eight edges of another
/// one, from `first` on, that may have a point in common, as long as it returns true. The first
/// operand is moved `by` a vector, and points up to `reach` apart count as common.
template <class Visit>
[[gnu::always_inline]] inline void for_each_near(const SmallEdges& edges, const SmallEdges& others,
                                                 const Vec<double>& by, double reach, Visit visit) {
  bool goes_on = true;
  for (std::size_t block = 0; block < edges.blocks.size && goes_on; ++block) {
    const BoxOf<double> box = moved(edges.blocks.box_of(block), by, reach);
    for (std::size_t word = 0; word < others.blocks.size && goes_on; word += 64) {
      for (LaneBits near = others.blocks.near(box, word); near != 0 && goes_on; near &= near - 1) {
        const std::size_t other = word + static_cast<std::size_t>(std::countr_zero(near));
        const auto first = static_cast<std::uint32_t>(other * kLanes);
        const BoxOf<double> back = moved(others.blocks.box_of(other), {-by.x, -by.y}, reach);
        for_each_bit(edges.near(block, back), [&](std::uint32_t lane) {
          goes_on = goes_on && visit(static_cast<std::uint32_t>(block * kLanes) + lane, first);
        });
      }
    }
  }
}
/// Whether two rings have a point of their boundaries in common.
template <class Number>
[[nodiscard, gnu::always_inline]] inline bool do_meet(const SmallOperand& a,
                                                      const SmallOperand& b) {
  const SmallEdges edges(a, a.size);
  const SmallEdges others(b, b.size);
  bool meet = false;
  for_each_near(
      edges, others, {0, 0},
      0, [&](std::uint32_t i, std::uint32_t first) __attribute__((always_inline)) {
        meet = (edges_meeting<Number>(edges.rows, i, others.rows, first) &
                others.lanes_of(first / kLanes)) != 0;
        return !meet;
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

// Tests whether small rings are simple, meet, or hold each other.
#pragma once

#include <algorithm>
#include <cmath>

#include "sum/small/blocks.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// The edges of a ring or of all rings of an operand, in blocks of eight.
struct SmallEdges {
  VecRow at;
  VecRow way;
  std::uint32_t size;
  double reach;
  SmallBlocks blocks;

  [[gnu::noinline]] SmallEdges(const SmallOperand& s, std::uint32_t edges, double by)
      : at(s.at()), way(s.way()), size(edges), reach(by) {
    blocks.set(at.x, at.y, way.x, way.y, size, reach);
  }
  /// Returns those of a block's eight entries that are edges.
  [[nodiscard]] LaneBits lanes_of(std::size_t block) const {
    return first_bits(std::min<std::size_t>(size - block * kLanes, kLanes));
  }
  /// Returns those of a block's edges whose boxes meet `box`.
  [[nodiscard, gnu::always_inline]] LaneBits near(std::size_t block,
                                                  const BoxOf<double>& box) const {
    const std::size_t i = block * kLanes;
    return segments_near(at.x + i, at.y + i, way.x + i, way.y + i, box) & lanes_of(block);
  }
  /// Whether each of a block's edges leads forward, as seen along the way from the first one's
  /// start to the last one's end. Then they meet at common vertices only. Rounding keeps the order
  /// of the two products, so a sum that comes out positive is positive, unless vectors are rounded.
  [[nodiscard, gnu::always_inline]] bool lead_forward(std::size_t block) const {
    const std::size_t first = block * kLanes;
    const std::size_t last = std::min<std::size_t>(first + kLanes, size) - 1;
    const Vec<double> along = minus(plus(at[last], way[last]), at[first]);
    LaneBits bits = 0;
    for (std::size_t t = 0; t < kLanes; ++t) {
      const Vec<double> edge = way[first + t];
      const double error = reach * (std::abs(edge.x) + std::abs(edge.y));
      bits |= dot(edge, along) > error ? kBitOf[t] : 0;
    }
    return (~bits & lanes_of(block)) == 0;
  }
};

/// Whether the boxes of two edges meet. The first one has this way, and sees the start of the
/// other one, t, at `a`.
template <class Integer>
[[nodiscard, gnu::always_inline]] inline bool do_boxes_meet(const Vec<Integer>& way,
                                                            const Vec<Integer>& a,
                                                            const Vec<Integer>& t) {
  const auto meet = [](Integer w, Integer to, Integer u) __attribute__((always_inline)) {
    const auto size = [](Integer value) { return value < 0 ? -value : value; };
    return size(2 * to + u - w) <= size(w) + size(u);
  };
  return meet(way.x, a.x, t.x) & meet(way.y, a.y, t.y);
}
/// Returns which of eight edges of a ring, from `first` on, edge i of another one meets. The
/// `wanted` ones are looked for.
template <class Number>
[[gnu::always_inline]] inline LaneBits edges_meeting(const SmallNumbers<Number>& numbers,
                                                     const SmallEdges& ring, std::uint32_t i,
                                                     const SmallEdges& others, std::size_t first,
                                                     LaneBits wanted) {
  const auto meets = [&](const auto& lanes, std::size_t lane) __attribute__((always_inline)) {
    const auto at = lanes.get(ring.at, i);
    const auto way = lanes.get(ring.way, i);
    const auto a = minus(lanes.get(others.at, first + lane), at);
    const auto t = lanes.get(others.way, first + lane);
    const auto [start, end, along, left] = sides(lanes, way, a, t);
    // Edges meet if neither lies on one side of the other's line, and if their boxes meet.
    bool meet = !((start > 0) & (end > 0)) & !((start < 0) & (end < 0)) &
                !((along > 0) & (left < 0)) & !((along < 0) & (left > 0));
    // Edges that are known to cross need no boxes, and others are tested again.
    if constexpr (!std::decay_t<decltype(lanes)>::kRoundsPoints) {
      meet = meet & do_boxes_meet(as_signed(way), as_signed(a), as_signed(t));
    }
    return meet ? kBitOf[lane] : 0;
  };
  return test_lanes(numbers, kLanes, wanted, meets) & wanted;
}

/// Returns how many pairs of blocks are compared at most where rings have so many edges. More take
/// longer than a sweep, which takes some 200 ns for an edge of a long spiky ring; a pair takes 150.
/// Rings of up to 512 edges have few enough.
[[nodiscard]] constexpr std::size_t most_pairs(std::size_t edges) { return edges + 1600; }

/// Whether no edge of a ring has a point in common with another one, but for the vertex between
/// neighbours. Returns false as well if telling takes longer than a sweep: if too many blocks of
/// edges are near one another.
template <class Number>
[[gnu::always_inline]] inline bool is_simple(const SmallNumbers<Number>& numbers,
                                             const SmallEdges& edges) {
  const std::uint32_t n = edges.size;
  std::size_t pairs_left = most_pairs(n);
  const auto may_meet = [&](std::size_t block, LaneBits lanes, std::size_t other)
      __attribute__((always_inline)) {
    if (pairs_left == 0) return true;
    --pairs_left;
    LaneBits met = 0;
    const auto first = static_cast<std::uint32_t>(other * kLanes);
    const LaneBits edges_of_other = edges.lanes_of(other);
    const auto bit = [first](std::uint32_t edge) {
      return edge - first < kLanes ? kBitOf[edge - first] : LaneBits{0};
    };
    for_each_bit(
        lanes, [&](std::uint32_t lane) __attribute__((always_inline)) {
          const auto i = static_cast<std::uint32_t>(block * kLanes) + lane;
          const LaneBits neighbours =
              bit(i) | bit(i + 1 == n ? 0 : i + 1) | bit(i == 0 ? n - 1 : i - 1);
          met |= edges_meeting(numbers, edges, i, edges, first, edges_of_other & ~neighbours);
        });
    return met != 0;
  };
  for (std::size_t block = 0; block < edges.blocks.size(); ++block) {
    // The earlier one of two edges of a block is not its last, nor, unless they are neighbours, the
    // last but one.
    const LaneBits earlier = edges.lanes_of(block) >> 2;
    if (earlier != 0 && !edges.lead_forward(block) && may_meet(block, earlier, block)) return false;
    const auto visit = [&](std::size_t first, LaneBits near) __attribute__((always_inline)) {
      for (; near != 0; near &= near - 1) {
        const std::size_t other = first + static_cast<std::size_t>(std::countr_zero(near));
        if (may_meet(block, edges.near(block, edges.blocks.box_of(other)), other)) return false;
      }
      return true;
    };
    if (!edges.blocks.for_each_near(edges.blocks.box_of(block), block + 1, visit)) return false;
  }
  return true;
}

/// Calls visit(i, first) for the edges i of one operand and the blocks of eight edges of another
/// one, from `first` on, that may have a point in common, as long as it returns true. The first
/// operand is moved `by` a vector, and points up to `reach` apart count as common. Takes each pair
/// of blocks that are near one another off `pairs_left`. Returns false if there are too few.
template <class Visit>
[[gnu::always_inline]] inline bool for_each_near(const SmallEdges& edges, const SmallEdges& others,
                                                 const Vec<double>& by, double reach,
                                                 std::size_t& pairs_left, Visit visit) {
  bool enough = true;
  const auto visit_pair = [&](std::size_t block, std::size_t other) __attribute__((always_inline)) {
    const auto first = static_cast<std::uint32_t>(other * kLanes);
    const BoxOf<double> back = moved(others.blocks.box_of(other), {-by.x, -by.y}, reach);
    enough = pairs_left > 0;
    if (!enough) return false;
    --pairs_left;
    for (LaneBits lanes = edges.near(block, back); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      if (!visit(static_cast<std::uint32_t>(block * kLanes) + lane, first)) return false;
    }
    return true;
  };
  const BoxOf<double> all = moved(others.blocks.box_of_all(), {-by.x, -by.y}, reach);
  for (std::size_t block = 0; block < edges.blocks.size(); ++block) {
    const BoxOf<double> box = edges.blocks.box_of(block);
    if (!box.meets(all)) continue;
    const auto visit_word = [&](std::size_t first, LaneBits near) __attribute__((always_inline)) {
      for (; near != 0; near &= near - 1) {
        if (!visit_pair(block, first + static_cast<std::size_t>(std::countr_zero(near)))) {
          return false;
        }
      }
      return true;
    };
    if (!others.blocks.for_each_near(moved(box, by, reach), 0, visit_word)) break;
  }
  return enough;
}
/// Whether two rings have a point of their boundaries in common, or telling takes too long.
template <class Number>
[[nodiscard, gnu::always_inline]] inline bool may_meet(const SmallNumbers<Number>& numbers,
                                                       const SmallEdges& edges,
                                                       const SmallEdges& others) {
  bool meet = false;
  std::size_t pairs_left = most_pairs(std::size_t{edges.size} + others.size);
  const bool done = for_each_near(
      edges, others, {0, 0}, 0,
      pairs_left, [&](std::uint32_t i, std::uint32_t first) __attribute__((always_inline)) {
        meet =
            edges_meeting(numbers, edges, i, others, first, others.lanes_of(first / kLanes)) != 0;
        return !meet;
      });
  return meet || !done;
}

/// Whether a ring of any orientation holds the first vertex of another one. The rings must not
/// meet.
template <class Number>
[[nodiscard]] inline bool holds(const SmallNumbers<Number>& numbers, const SmallOperand& a,
                                const SmallOperand& b) {
  const auto lanes = sure_lanes(numbers);
  const auto at = lanes.get(b.at(), 0);
  bool inside = false;
  for (std::uint32_t i = 0; i < a.size; ++i) {
    const auto edge = lanes.get(a.way(), i);
    const auto point = minus(at, lanes.get(a.at(), i));
    const auto height = as_signed(edge).y;
    const auto y = as_signed(point).y;
    // This counts edges that pass the height of the point, on its right.
    const bool up = y >= 0 && y < height;
    const bool down = y < 0 && y >= height;
    if (!up && !down) continue;
    const double side = lanes.side(edge, point);
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

// Tests whether rings of small operands meet, and where their edges are near others.
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
  SmallBlocks& blocks;

  /// The blocks are kept in `memory`.
  [[gnu::noinline]] SmallEdges(const SmallOperand& s, std::uint32_t edges, double by,
                               SmallBlocks& memory)
      : at(s.at()), way(s.way()), size(edges), reach(by), blocks(memory) {
    blocks.set(at.x, at.y, way.x, way.y, size, reach);
  }
  /// Returns those of a block's eight entries whose boxes meet `box`.
  [[nodiscard, gnu::always_inline]] LaneBits near(std::size_t block,
                                                  const BoxOf<double>& box) const {
    const std::size_t i = block * kLanes;
    return segments_near(at.x + i, at.y + i, way.x + i, way.y + i, box);
  }
  /// Whether each of a block's first edges leads forward, as seen along the way from the first
  /// one's start to the last one's end. Then they meet at common vertices only. Rounding keeps the
  /// order of the two products, so a sum that comes out positive is positive, unless vectors are
  /// rounded.
  [[nodiscard, gnu::always_inline]] bool lead_forward(std::size_t block, std::size_t count) const {
    const std::size_t first = block * kLanes;
    const std::size_t last = first + count - 1;
    const Vec<double> along = minus(plus(at[last], way[last]), at[first]);
    LaneBits bits = 0;
    for (std::size_t t = 0; t < kLanes; ++t) {
      const Vec<double> edge = way[first + t];
      const double error = reach * (std::abs(edge.x) + std::abs(edge.y));
      bits |= dot(edge, along) > error ? kBitOf[t] : 0;
    }
    return (~bits & first_bits(count)) == 0;
  }
};

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

/// Whether no edge of an operand has a point in common with another one, but for the vertex between
/// neighbours. Returns false as well if telling takes longer than a sweep: if too many blocks of
/// edges are near one another.
template <class Number>
[[gnu::always_inline]] inline bool are_apart(const SmallNumbers<Number>& numbers,
                                             const SmallEdges& edges, const SmallOperand& s) {
  std::size_t pairs_left = most_pairs(edges.size);
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  const auto may_meet = [&](std::size_t block, LaneBits lanes, std::size_t other)
      __attribute__((always_inline)) {
    if (pairs_left == 0) return true;
    --pairs_left;
    LaneBits met = 0;
    const auto first = static_cast<std::uint32_t>(other * kLanes);
    // Behind a ring, entries are at its first vertex, where the ring's edges meet them.
    const LaneBits edges_of_other = first < end ? first_bits(end - first) : ~LaneBits{0};
    const auto bit = [first](std::uint32_t edge) {
      return edge - first < kLanes ? kBitOf[edge - first] : LaneBits{0};
    };
    for_each_bit(
        lanes, [&](std::uint32_t lane) __attribute__((always_inline)) {
          const auto i = static_cast<std::uint32_t>(block * kLanes) + lane;
          const LaneBits neighbours =
              bit(i) | bit(i + 1 == end ? begin : i + 1) | bit(i == begin ? end - 1 : i - 1);
          met |= edges_meeting(numbers, edges, i, edges, first, edges_of_other & ~neighbours);
        });
    return met != 0;
  };
  const auto meets_none = [&](std::size_t block) __attribute__((always_inline)) {
    // The earlier one of two edges of a block is not its last, nor, unless they are neighbours, the
    // last but one.
    const std::size_t count = std::min<std::size_t>(end - block * kLanes, kLanes);
    const LaneBits lanes = first_bits(count);
    if (count > 2 && !edges.lead_forward(block, count) && may_meet(block, lanes >> 2U, block)) {
      return false;
    }
    const auto visit = [&](std::size_t first, LaneBits near) __attribute__((always_inline)) {
      for (; near != 0; near &= near - 1) {
        const std::size_t other = first + static_cast<std::size_t>(std::countr_zero(near));
        const LaneBits near_other = edges.near(block, edges.blocks.box_of(other));
        if (may_meet(block, near_other & lanes, other)) return false;
      }
      return true;
    };
    return edges.blocks.for_each_near(edges.blocks.box_of(block), block + 1, visit);
  };
  for (std::size_t ring = 0; ring < s.ends.size(); ++ring) {
    begin = s.begin_of(ring);
    end = s.ends[ring];
    for (std::size_t block = begin / kLanes; block * kLanes < end; ++block) {
      if (!meets_none(block)) return false;
    }
  }
  return true;
}

/// Whether the only outer ring holds each hole, and no hole holds another one. No rings may meet.
template <class Number>
[[gnu::always_inline]] inline bool are_holes_inside(const SmallNumbers<Number>& numbers,
                                                    const SmallEdges& edges,
                                                    const SmallOperand& s) {
  for (std::size_t hole = 1; hole < s.ends.size(); ++hole) {
    const std::uint32_t vertex = s.begin_of(hole);
    // A ray to the right crosses a ring that holds the vertex an odd number of times.
    const auto crosses = [&](std::size_t i) {
      return compute_surely(numbers, [&](const auto& lanes) {
        const auto edge = lanes.get(edges.way, i);
        const auto point = minus(lanes.get(edges.at, vertex), lanes.get(edges.at, i));
        const auto height = as_signed(edge).y;
        const auto y = as_signed(point).y;
        const decltype(y) zero(0);
        const bool up = y >= zero && y < height;
        const bool down = y < zero && y >= height;
        if (!up && !down) return false;
        const double side = lanes.side(edge, point);
        return up ? side > 0 : side < 0;
      });
    };
    const Vec<double> near = edges.at[vertex];
    const BoxOf<double> point{near.x - edges.reach, near.y - edges.reach, near.x + edges.reach,
                              near.y + edges.reach};
    const BoxOf<double> ray{point.x0, point.y0, HUGE_VAL, point.y1};
    LaneBits holding = 0;
    const auto visit = [&](std::size_t first, LaneBits blocks) __attribute__((always_inline)) {
      for (; blocks != 0; blocks &= blocks - 1) {
        const std::size_t block = first + static_cast<std::size_t>(std::countr_zero(blocks));
        const std::size_t begin = block * kLanes;
        const std::size_t ring = s.ring_of(static_cast<std::uint32_t>(begin));
        // Nothing follows from the hole's own ring. A ring in one block holds only what the block's
        // box holds.
        const bool whole = begin == s.begin_of(ring) && s.ends[ring] <= begin + kLanes;
        if (ring == hole || (whole && !edges.blocks.box_of(block).meets(point))) continue;
        bool odd = false;
        for (LaneBits bits = edges.near(block, ray); bits != 0; bits &= bits - 1) {
          odd = odd != crosses(begin + static_cast<std::size_t>(std::countr_zero(bits)));
        }
        if (odd) holding ^= LaneBits{1} << ring;
      }
      return true;
    };
    edges.blocks.for_each_near(ray, 0, visit);
    constexpr LaneBits kOuterRing = 1;
    if (holding != kOuterRing) return false;
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

}  // namespace minksum

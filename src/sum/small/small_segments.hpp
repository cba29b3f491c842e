// Lists the reduced convolution of two small operands.
#pragma once

#include <tuple>
#include <utility>

#include "sum/cover/cover.hpp"
#include "sum/small/blocks.hpp"
#include "sum/small/small_operand.hpp"

namespace minksum {

/// An edge of one operand, moved by a vertex of the other.
struct SegmentOrigin {
  std::uint32_t edge;
  std::uint32_t vertex : 31;
  std::uint32_t of_first : 1;  ///< whether the edge is the first operand's

  SegmentOrigin() = default;
  SegmentOrigin(std::uint32_t edge_, std::uint32_t vertex_, bool is_of_first)
      : edge(edge_), vertex(vertex_ & 0x7fffffffU), of_first(is_of_first) {}
};

/// Vectors in doubles, and the places that they start at.
struct SegmentRows {
  static constexpr std::size_t kMax = std::size_t{1} << 15;
  /// Rows are longer than kMax, so that entries of the same index lie in different places of a
  /// page. Then a store to one row does not hold up loads from another.
  using Row = std::array<double, kMax + 128>;

  alignas(64) Row x;
  alignas(64) Row y;
  alignas(64) Row dx;
  alignas(64) Row dy;

  /// Returns those of a block's eight entries whose boxes meet `box`.
  [[nodiscard, gnu::always_inline]] LaneBits near(std::size_t block,
                                                  const BoxOf<double>& box) const {
    const std::size_t i = block * kLanes;
    return segments_near(&x[i], &y[i], &dx[i], &dy[i], box);
  }
  void copy(const SegmentRows& other, std::uint32_t from, std::uint32_t to) {
    x[to] = other.x[from];
    y[to] = other.y[from];
    dx[to] = other.dx[from];
    dy[to] = other.dy[from];
  }
};

/// The segments of a small sum. All numbers are integers, which doubles may round. Of the arrays,
/// only what is used takes memory: others' pages are never touched.
struct SmallSegments : SegmentRows {
  std::uint32_t size;
  std::uint32_t left_out;  ///< number of others, which lie inside the sum or equal one of these
  bool wide;               ///< whether doubles round the numbers
  bool in_part;            ///< whether it is known which parts of segments may be boundary
  /// These are only set where doubles round the numbers. Ends that are sums of the same two
  /// vertices have the same number.
  alignas(64) Row start;
  alignas(64) Row end;
  SegmentRows part;  ///< the parts' boxes, as lower left corners and extents
  std::array<SegmentOrigin, kMax> origin;
  std::array<const SmallOperand*, 2> operands;  ///< by `of_first`
  SmallBlocks blocks;

  /// Copies another's entry.
  [[gnu::always_inline]] void copy(const SmallSegments& other, std::uint32_t from,
                                   std::uint32_t to) {
    SegmentRows::copy(other, from, to);
    origin[to] = other.origin[from];
    if (other.in_part) part.copy(other.part, from, to);
    if (other.wide) {
      start[to] = other.start[from];
      end[to] = other.end[from];
    }
  }
  /// Gets ready for copies of another's entries.
  void clear_as(const SmallSegments& other) {
    size = 0;
    left_out = 0;
    wide = other.wide;
    in_part = other.in_part;
    operands = other.operands;
  }
  struct AtRow {
    const SmallSegments& s;
    [[nodiscard]] Vec<double> operator[](std::size_t i) const { return {s.x[i], s.y[i]}; }
    template <class Integer>
    [[nodiscard]] Vec<Integer> exact(std::size_t i) const {
      const SegmentOrigin& o = s.origin[i];
      return plus(s.operands[o.of_first]->exact<Integer>(SmallOperand::kX, o.edge),
                  s.operands[1 - o.of_first]->exact<Integer>(SmallOperand::kX, o.vertex));
    }
  };
  struct WayRow {
    const SmallSegments& s;
    [[nodiscard]] Vec<double> operator[](std::size_t i) const { return {s.dx[i], s.dy[i]}; }
    template <class Integer>
    [[nodiscard]] Vec<Integer> exact(std::size_t i) const {
      const SegmentOrigin& o = s.origin[i];
      return s.operands[o.of_first]->exact<Integer>(SmallOperand::kDx, o.edge);
    }
  };
  [[nodiscard]] AtRow at() const { return {*this}; }
  [[nodiscard]] WayRow way() const { return {*this}; }

  /// Returns those of a block's eight entries that are segments.
  [[nodiscard]] LaneBits lanes_of(std::size_t block) const {
    return first_bits(std::min<std::size_t>(size - block * kLanes, kLanes));
  }
  /// Returns the rows whose boxes are compared: those of parts where they are known.
  [[nodiscard]] const SegmentRows& boxes() const { return in_part ? part : *this; }
  [[nodiscard, gnu::always_inline]] BoxOf<double> box_of_part(std::size_t i) const {
    return {part.x[i], part.y[i], part.x[i] + part.dx[i], part.y[i] + part.dy[i]};
  }
  void set_part(std::size_t i, const BoxOf<double>& box) {
    part.x[i] = box.x0;
    part.y[i] = box.y0;
    part.dx[i] = box.x1 - box.x0;
    part.dy[i] = box.y1 - box.y0;
  }
  /// Returns about the middle of a segment's visible part.
  [[nodiscard]] Vec<double> middle_of(std::uint32_t i) const {
    const SegmentRows& rows = boxes();
    return {rows.x[i] + rows.dx[i] / 2, rows.y[i] + rows.dy[i] / 2};
  }
  /// Whether segment i was listed before segment j. Segments are listed by vertices of the first
  /// ring.
  [[nodiscard]] bool is_before(std::uint32_t i, std::uint32_t j) const {
    const auto place = [this](std::uint32_t k) {
      const SegmentOrigin& o = origin[k];
      return o.of_first ? std::tuple(o.edge, true, o.vertex) : std::tuple(o.vertex, false, o.edge);
    };
    return place(i) < place(j);
  }
  /// Must be called when all segments are listed. Fills up the rows, so that they can be read eight
  /// entries at a time. Places are rounded by less than `reach`.
  void finish(double reach);
  /// Whether far more blocks are near one another than need be. A block of segments that are listed
  /// in a good order has about three near ones, with itself. Ordering takes as long as comparing
  /// ten pairs of blocks.
  [[nodiscard]] bool is_out_of_order() const;
};

/// Leaves out one of every two equal segments of a sum P ⊕ P: an edge at a vertex is listed for
/// both operands, unless it is parallel to an edge at that vertex. Keeps the one that was listed
/// first. `width` is the larger extent of the sum.
void drop_copies(const SmallOperand& p, double width, SmallSegments& segments);

/// Leaves out the segments that touch no uncovered cell. `uncovered` is memory.
void drop_hidden(const Cover& cover, UncoveredRows& uncovered, SmallSegments& segments);

/// A sample of the segments that touch an uncovered cell.
struct SmallSample {
  double share;         ///< which share of these segments it has
  std::uint32_t whole;  ///< about how many segments touch an uncovered cell
};
/// Copies one of every few segments that touch an uncovered cell, at random distances.
SmallSample take_sample(const Cover& cover, const SmallSegments& from, SmallSegments& to);

/// Returns the most meetings on the right that so many segments may have. If they have more, most
/// corners lie inside, and the stages are mostly faster. With 1.25, 1.5, 2, 2.5 and 3 for each
/// segment, 544 random sums that come near this took 0.85, 0.85, 0.81, 0.81 and 0.80 of the stages'
/// time, on the geometric mean. 5, 6, 4, 8 and 10 of them took over twice that time.
[[nodiscard]] constexpr std::uint32_t most_right_meetings(std::uint32_t segments) {
  return 2 * segments + 16;
}

/// Returns those of up to 64 vertices of the second operand whose (in, out] has an edge's
/// direction.
template <class Number>
[[gnu::always_inline]] inline LaneBits vertices_meeting(const SmallNumbers<Number>& numbers,
                                                        const SmallOperand& o, std::size_t first,
                                                        std::size_t count, const VecRow& edges,
                                                        std::size_t edge) {
  const VecRow in = o.in();
  const VecRow out = o.out();
  const auto meets = [&](const auto& lanes, std::size_t v) __attribute__((always_inline)) {
    const auto way = lanes.get(edges, edge);
    const bool meet = (lanes.turn(lanes.get(in, first + v), way) > 0) &
                      (lanes.turn(way, lanes.get(out, first + v)) >= 0);
    return meet ? kBitOf[v] : 0;
  };
  return test_lanes(numbers, count / kLanes * kLanes, ~LaneBits{0}, meets);
}
/// Returns those of up to 64 edges whose direction is in [in, out) of a first operand's vertex.
template <class Number>
[[gnu::always_inline]] inline LaneBits edges_between(const SmallNumbers<Number>& numbers,
                                                     const SmallOperand& o, std::size_t first,
                                                     std::size_t count, const SmallOperand& other,
                                                     std::size_t vertex) {
  const VecRow edges = o.way();
  const VecRow in = other.in();
  const VecRow out = other.out();
  const auto between = [&](const auto& lanes, std::size_t e) __attribute__((always_inline)) {
    const auto edge = lanes.get(edges, first + e);
    return ((lanes.turn(lanes.get(in, vertex), edge) >= 0) &
            (lanes.turn(edge, lanes.get(out, vertex)) > 0))
               ? kBitOf[e]
               : 0;
  };
  return test_lanes(numbers, count / kLanes * kLanes, ~LaneBits{0}, between);
}

/// Lists the reduced convolution in the order of the first operand's rings. So segments that are
/// near in the plane are mostly near in the list. Without `with_holes`, an operand's holes are
/// filled. Returns false if there are too many segments.
template <class Number>
[[gnu::always_inline]] inline bool list_segments(const SmallNumbers<Number>& numbers,
                                                 const SmallOperand& p, const SmallOperand& q,
                                                 const std::array<bool, 2>& with_holes,
                                                 SmallSegments& s) {
  const std::uint32_t m = with_holes[0] ? p.entries : p.size;
  const std::size_t n = filled_up(with_holes[1] ? q.entries : q.size);
  std::uint32_t size = 0;
  struct Rows {
    VecRow at;
    VecRow way;
  };
  const Rows of_p{p.at(), p.way()};
  const Rows of_q{q.at(), q.way()};
  const double* const in_x = p[SmallOperand::kInX];
  const double* const in_y = p[SmallOperand::kInY];
  const auto append = [&](const Rows& edges, std::size_t e, const Rows& vertices, std::size_t v,
                          bool of_first) __attribute__((always_inline)) {
    s.x[size] = edges.at.x[e] + vertices.at.x[v];
    s.y[size] = edges.at.y[e] + vertices.at.y[v];
    s.dx[size] = edges.way.x[e];
    s.dy[size] = edges.way.y[e];
    if constexpr (std::is_same_v<Number, WideNumber>) {
      const auto number = [&](std::size_t of_edge) {
        const std::size_t i = of_first ? of_edge : v;
        const std::size_t j = of_first ? v : of_edge;
        return static_cast<double>(i * SmallOperand::kMaxEntries + j);
      };
      const SmallOperand& o = of_first ? p : q;
      s.start[size] = number(e);
      s.end[size] = number(o.ends_of(false, static_cast<std::uint32_t>(e)).to);
    }
    s.origin[size] = {static_cast<std::uint32_t>(e), static_cast<std::uint32_t>(v), of_first};
    ++size;
  };
  const auto fit = [&](LaneBits bits) {
    return size + static_cast<std::uint32_t>(std::popcount(bits)) <= SmallSegments::kMax;
  };
  for (std::uint32_t i = 0; i < m; ++i) {
    const bool convex = in_x[i] != 0 || in_y[i] != 0;
    for (std::size_t first = 0; first < n; first += 64) {
      const std::size_t count = std::min<std::size_t>(n - first, 64);
      const LaneBits at_vertex = convex ? edges_between(numbers, q, first, count, p, i) : 0;
      if (!fit(at_vertex)) return false;
      for_each_bit(at_vertex, [&](std::uint32_t e) { append(of_q, first + e, of_p, i, false); });
      const LaneBits of_edge = vertices_meeting(numbers, q, first, count, of_p.way, i);
      if (!fit(of_edge)) return false;
      for_each_bit(of_edge, [&](std::uint32_t v) { append(of_p, i, of_q, first + v, true); });
    }
  }
  s.size = size;
  s.left_out = 0;
  s.in_part = false;
  s.wide = std::is_same_v<Number, WideNumber>;
  s.operands = {&q, &p};
  return true;
}

/// Sorts segments by cells, of which there is one for every few segments, in the order of Hilbert's
/// curve. Then segments that are near one another in the plane are near in the list. O(s).
class SmallOrder {
 public:
  /// `extent` is the sum's, and places are rounded by less than `reach`.
  void apply(const SmallSegments& from, const Vec<double>& extent, double reach, SmallSegments& to);

 private:
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> cell_;
};

}  // namespace minksum

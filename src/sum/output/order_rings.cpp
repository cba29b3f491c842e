// Groups rings into polygons, in canonical order.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sum/output/node_order.hpp"
#include "sum/output/output.hpp"

namespace minksum {
namespace {

constexpr std::uint32_t kNoRing = 0xFFFFFFFFU;

class PolygonBuilder {
 public:
  PolygonBuilder(const Arrangement& arrangement, Predicates& predicates, OutputScratch& scratch,
                 Boundary& boundary)
      : arrangement_(arrangement),
        order_(arrangement, predicates),
        cancellation_(predicates.cancellation()),
        scratch_(scratch),
        b_(boundary) {}

  void run() {
    assign_holes();
    auto& order = b_.ring_order;
    order.resize(b_.rings.size());
    for (std::uint32_t r = 0; r < order.size(); ++r) order[r] = r;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t outer_a = scratch_.outer_of[a];
      const std::uint32_t outer_b = scratch_.outer_of[b];
      if (outer_a != outer_b) return ring_before(outer_a, outer_b);
      if (a == outer_a || b == outer_b) return a == outer_a && b != outer_b;
      return ring_before(a, b);
    };
    std::sort(order.begin(), order.end(), cancellation_.counting(before));
    b_.polygon_begin.clear();
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      if (b_.rings[order[i]].positive) b_.polygon_begin.push_back(i);
    }
    b_.polygon_begin.push_back(static_cast<std::uint32_t>(order.size()));
  }

 private:
  [[nodiscard]] NodeId node(std::uint32_t ring, std::uint32_t k) const {
    return b_.vertices[b_.rings[ring].begin + k].node;
  }
  /// Whether ring a comes before ring b. They differ in their first vertex, or else in the second.
  [[nodiscard]] bool ring_before(std::uint32_t a, std::uint32_t b) const {
    const Sign first = order_.compare(node(a, 0), node(b, 0));
    return (first != kZero ? first : order_.compare(node(a, 1), node(b, 1))) == kNegative;
  }

  void assign_holes() {
    const auto rings = static_cast<std::uint32_t>(b_.rings.size());
    scratch_.outer_of.assign(rings, kNoRing);
    scratch_.rows.begin.clear();
    std::uint32_t outers = 0;
    std::uint32_t some_outer = kNoRing;
    for (std::uint32_t r = 0; r < rings; ++r) {
      if (!b_.rings[r].positive) continue;
      scratch_.outer_of[r] = r;
      some_outer = r;
      ++outers;
    }
    if (outers == 1) {
      std::fill(scratch_.outer_of.begin(), scratch_.outer_of.end(), some_outer);
      return;
    }
    // Rings of one walk lie next to each other in the list.
    for (std::uint32_t first = 0; first < rings;) {
      std::uint32_t last = first;
      while (last < rings && b_.rings[last].walk == b_.rings[first].walk) ++last;
      assign_walk(first, last);
      first = last;
    }
  }
  void assign_walk(std::uint32_t first, std::uint32_t last) {
    std::uint32_t outer = kNoRing;
    std::uint32_t leftmost = first;
    for (std::uint32_t r = first; r < last; ++r) {
      if (b_.rings[r].positive) {
        if (outer != kNoRing) {
          throw Error(ErrorCode::kInternal, "a walk has two outer rings", {}, "output");
        }
        outer = r;
      }
      if (order_.compare(node(r, 0), node(leftmost, 0)) == kNegative) leftmost = r;
    }
    if (outer == kNoRing) outer = surrounding(node(leftmost, 0));
    for (std::uint32_t r = first; r < last; ++r) scratch_.outer_of[r] = outer;
  }

  /// Returns the innermost outer ring around the point just left of (and less far below) a node.
  /// That point is inside the sum if the node is the smallest of its hole.
  std::uint32_t surrounding(NodeId at) {
    auto& around = scratch_.around;
    list_around(at, around);
    std::uint32_t best = kNoRing;
    std::uint32_t best_depth = 0;
    // Outer rings around one point lie in each other.
    for (const std::uint32_t r : around) {
      std::uint32_t depth = 1;
      if (around.size() > 1) {
        for (const std::uint32_t other : around) {
          if (other != r && contains(other, node(r, 0))) ++depth;
        }
      }
      if (depth > best_depth) {
        best = r;
        best_depth = depth;
      }
    }
    if (best == kNoRing) {
      throw Error(ErrorCode::kInternal, "a hole lies in no outer ring", {}, "output");
    }
    return best;
  }

  /// Lists the outer rings that contain the point just left of a node.
  void list_around(NodeId at, std::vector<std::uint32_t>& around) {
    if (scratch_.rows.begin.empty()) build_rows();
    const RowIndex& rows = scratch_.rows;
    around.clear();
    const std::size_t row = row_of(arrangement_.nodes[at].at.y);
    for (std::uint32_t i = rows.begin[row]; i < rows.begin[row + 1]; ++i) {
      const RowIndex::Edge& edge = rows.edges[i];
      if (!passes(b_.rings[edge.ring], edge.vertex, at)) continue;
      scratch_.odd[edge.ring] ^= 1;
      around.push_back(edge.ring);
    }
    // This keeps the rings that were passed an odd number of times, once each.
    std::erase_if(around, [&](std::uint32_t r) { return std::exchange(scratch_.odd[r], 0) == 0; });
  }

  [[nodiscard]] std::size_t row_of(double y) const {
    const RowIndex& rows = scratch_.rows;
    const double row = (y - rows.bottom) * rows.inverse;
    const auto last = static_cast<double>(rows.count - 1);
    return static_cast<std::size_t>(std::clamp(row, 0.0, last));
  }
  void build_rows() {
    RowIndex& rows = scratch_.rows;
    double top = -HUGE_VAL;
    std::size_t edges = 0;
    rows.bottom = HUGE_VAL;
    rows.error = 0;
    for_each_outer_edge([&](RowIndex::Edge, const Node& v, const Node&) {
      rows.bottom = std::min(rows.bottom, v.at.y);
      top = std::max(top, v.at.y);
      rows.error = std::max(rows.error, v.error);
      ++edges;
    });
    const std::size_t count = std::clamp<std::size_t>(edges / 4, 1, 1U << 20U);
    const double height = top - rows.bottom;
    rows.inverse = height > 0x1p-900 ? static_cast<double>(count) / height : 0;
    rows.count = count;
    rows.begin.assign(count + 2, 0);
    // The edge's end and the point that is asked about each have that error.
    const auto for_each_row = [&](const Node& v, const Node& w, auto visit) {
      const std::size_t first = row_of(std::min(v.at.y, w.at.y) - 2 * rows.error);
      const std::size_t last = row_of(std::max(v.at.y, w.at.y) + 2 * rows.error);
      cancellation_.check(last - first);
      for (std::size_t row = first; row <= last; ++row) visit(row);
    };
    for_each_outer_edge([&](RowIndex::Edge, const Node& v, const Node& w) {
      for_each_row(v, w, [&](std::size_t row) { ++rows.begin[row + 2]; });
    });
    for (std::size_t i = 2; i < rows.begin.size(); ++i) rows.begin[i] += rows.begin[i - 1];
    rows.edges.resize(rows.begin.back());
    for_each_outer_edge([&](RowIndex::Edge edge, const Node& v, const Node& w) {
      for_each_row(v, w, [&](std::size_t row) { rows.edges[rows.begin[row + 1]++] = edge; });
    });
    rows.begin.pop_back();
    scratch_.odd.assign(b_.rings.size(), 0);
  }
  template <class Visit>
  void for_each_outer_edge(Visit visit) const {
    for (std::uint32_t r = 0; r < b_.rings.size(); ++r) {
      const BoundaryRing& ring = b_.rings[r];
      if (!ring.positive) continue;
      for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
        const std::uint32_t next = i + 1 == ring.end ? ring.begin : i + 1;
        cancellation_.check();
        visit(RowIndex::Edge{r, i}, arrangement_.nodes[b_.vertices[i].node],
              arrangement_.nodes[b_.vertices[next].node]);
      }
    }
  }

  /// Whether the point (−ε, −ε²) off a node is inside a ring, by parity along a ray to the right.
  bool contains(std::uint32_t ring, NodeId at) {
    const BoundaryRing& r = b_.rings[ring];
    bool inside = false;
    for (std::uint32_t i = r.begin; i < r.end; ++i) inside ^= passes(r, i, at);
    return inside;
  }
  /// Whether the ray passes the edge that starts at vertex i.
  bool passes(const BoundaryRing& r, std::uint32_t i, NodeId at) {
    cancellation_.check(2);
    const BoundaryVertex& v = b_.vertices[i];
    const BoundaryVertex& w = b_.vertices[i + 1 == r.end ? r.begin : i + 1];
    // A node at the same height is above the point.
    const bool v_above = order_.compare(v.node, at, Axis::kY) != kNegative;
    const bool w_above = order_.compare(w.node, at, Axis::kY) != kNegative;
    if (v_above == w_above) return false;
    // If the node is on the edge's line, the point is off to the left: the left side of a rising
    // edge.
    Sign side = order_.orientation(
        arrangement_.kept[arrangement_.pieces[v.piece].segment].segment, at);
    if (side == kZero) side = w_above ? kPositive : kNegative;
    return (side == kPositive) == w_above;
  }

  const Arrangement& arrangement_;
  NodeOrder order_;
  Cancellation& cancellation_;
  OutputScratch& scratch_;
  Boundary& b_;
};

}  // namespace

void order_rings(const Arrangement& arrangement, Predicates& predicates, OutputScratch& scratch,
                 Boundary& boundary) {
  PolygonBuilder(arrangement, predicates, scratch, boundary).run();
}

}  // namespace minksum

// Groups rings into polygons, in canonical order.
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "machine/make_room.hpp"
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
    scratch_.lone.clear();
    // Rings of one walk lie next to each other in the list.
    for (std::uint32_t first = 0; first < rings;) {
      std::uint32_t last = first;
      while (last < rings && b_.rings[last].walk == b_.rings[first].walk) ++last;
      assign_walk(first, last);
      first = last;
    }
    if (!scratch_.lone.empty()) assign_lone_walks();
  }
  /// Assigns the rings of a walk to its outer ring. A walk without one is only listed.
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
    if (outer == kNoRing) return scratch_.lone.push_back({first, last, node(leftmost, 0)});
    for (std::uint32_t r = first; r < last; ++r) scratch_.outer_of[r] = outer;
  }

  /// Assigns walks without an outer ring to the innermost ring around the point just left of (and
  /// less far below) their leftmost node. That point is inside the sum.
  void assign_lone_walks() {
    list_passes();
    auto& passes = scratch_.passes;
    std::sort(passes.begin(), passes.end(), cancellation_.counting(std::less<>()));
    auto& around = scratch_.around;
    std::size_t i = 0;
    for (std::uint32_t w = 0; w < scratch_.lone.size(); ++w) {
      // The rings that are passed an odd number of times are around the point.
      around.clear();
      while (i < passes.size() && passes[i].first == w) {
        const std::size_t begin = i;
        while (i < passes.size() && passes[i] == passes[begin]) ++i;
        if ((i - begin) % 2 != 0) around.push_back(passes[begin].second);
      }
      const LoneWalk& walk = scratch_.lone[w];
      const std::uint32_t outer = innermost(around);
      for (std::uint32_t r = walk.first; r < walk.last; ++r) scratch_.outer_of[r] = outer;
    }
  }
  /// Returns the innermost of the rings around a point, which lie in each other.
  std::uint32_t innermost(std::span<const std::uint32_t> around) {
    std::uint32_t best = kNoRing;
    std::uint32_t best_depth = 0;
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

  /// Lists which outer rings the rays from lone walks pass, as often as they do.
  void list_passes() {
    build_rows();
    const WalkRows& rows = scratch_.rows;
    scratch_.passes.clear();
    for (std::uint32_t r = 0; r < b_.rings.size(); ++r) {
      const BoundaryRing& ring = b_.rings[r];
      if (!ring.positive) continue;
      const Node* v = &arrangement_.nodes[b_.vertices[ring.end - 1].node];
      std::uint32_t from = ring.end - 1;
      for (std::uint32_t i = ring.begin; i < ring.end; from = i++) {
        const Node* const w = &arrangement_.nodes[b_.vertices[i].node];
        // The edge's ends and the node that is asked about each have that error.
        const double error = rows.error + std::max(v->error, w->error);
        const std::size_t first = rows.row_of(std::min(v->at.y, w->at.y) - error);
        const std::size_t last = rows.row_of(std::max(v->at.y, w->at.y) + error);
        const std::uint32_t begin = rows.begin[first];
        const std::uint32_t end = rows.begin[last + 1];
        cancellation_.check(1 + (end - begin));
        for (std::uint32_t k = begin; k < end; ++k) {
          const std::uint32_t walk = rows.walks[k];
          if (passes(ring, from, scratch_.lone[walk].leftmost)) {
            append(scratch_.passes, {walk, r}, cancellation_);
          }
        }
        v = w;
      }
    }
  }
  /// Puts lone walks into rows of the plane, by the heights of their leftmost nodes.
  void build_rows() {
    WalkRows& rows = scratch_.rows;
    const auto& lone = scratch_.lone;
    double top = -HUGE_VAL;
    rows.bottom = HUGE_VAL;
    rows.error = 0;
    for (const LoneWalk& walk : lone) {
      const Node& at = arrangement_.nodes[walk.leftmost];
      rows.bottom = std::min(rows.bottom, at.at.y);
      top = std::max(top, at.at.y);
      rows.error = std::max(rows.error, at.error);
    }
    // Edges between the lowest and the highest of these nodes look at a row or more. Outside lie
    // the first row and the last, which hold no walk.
    rows.count = std::min<std::size_t>(4 * lone.size(), 1U << 20U);
    const double height = top - rows.bottom;
    rows.inverse = height > 0x1p-900 ? static_cast<double>(rows.count) / height : 1;
    list_by_key(rows.count + 2, cancellation_, rows.begin, rows.walks, [&](auto visit) {
      cancellation_.check(lone.size());
      for (std::uint32_t w = 0; w < lone.size(); ++w) {
        visit(rows.row_of(arrangement_.nodes[lone[w].leftmost].at.y), w);
      }
    });
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

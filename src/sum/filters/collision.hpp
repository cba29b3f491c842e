// The exact collision test, which decides whether P meets x − Q.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "exact/predicates.hpp"
#include "spatial/box.hpp"
#include "sum/operands/operands.hpp"

namespace minksum {

/// A binary tree of boxes over one operand's edges, level by level from the leaves. A leaf has a
/// few edges of one ring. Rings are in the order of a division at medians, so that rings that are
/// near in the tree are near in the plane. Each ring's edges are in their own order.
class BoxTree {
 public:
  using Box = BoxOf<double>;
  static constexpr SiteId kLeafEdges = 4;
  /// Consecutive leaves, or the edges of a leaf.
  struct Range {
    std::uint32_t begin;
    std::uint32_t end;
  };

  /// `ring_boxes` are by ring of both operands.
  void build(const Operands& operands, int operand, const std::vector<Box>& ring_boxes);
  [[nodiscard]] std::size_t levels() const { return levels_; }
  [[nodiscard]] std::size_t nodes(std::size_t level) const {
    return first_[level + 1] - first_[level];
  }
  [[nodiscard]] const Box& box(std::size_t level, std::size_t node) const {
    return boxes_[first_[level] + node];
  }
  /// Returns the box of all edges.
  [[nodiscard]] const Box& whole() const { return boxes_.back(); }
  /// Pointers to the boxes of a tree that does not change: a loop may keep them in registers.
  struct Boxes {
    const Box* boxes;
    const std::size_t* first;
    [[nodiscard]] const Box& at(std::size_t level, std::size_t node) const {
      return boxes[first[level] + node];
    }
  };
  [[nodiscard]] Boxes boxes() const { return {boxes_.data(), first_.data()}; }
  /// Returns the edges of a leaf, a node of level 0.
  [[nodiscard]] const Range& edges_of(std::size_t leaf) const { return leaves_[leaf]; }
  [[nodiscard]] Range leaves() const { return {0, static_cast<std::uint32_t>(leaves_.size())}; }
  /// Returns the leaves of a ring of the operand, which is counted among the rings of both.
  [[nodiscard]] const Range& leaves_of(std::size_t ring) const {
    return leaves_of_ring_[ring - first_ring_];
  }
  /// Whether visit(edge) holds for an edge of these leaves. Edges in boxes for which skip(box)
  /// holds may be left out. O(log n) for each leaf that is not.
  template <class Skip, class Visit>
  bool any_edge(Range leaves, Skip skip, Visit visit) const {
    const Boxes boxes = this->boxes();
    const std::size_t levels = levels_;
    for (std::size_t leaf = leaves.begin; leaf < leaves.end;) {
      if (!skip(boxes.boxes[leaf])) {
        for (SiteId e = leaves_[leaf].begin; e < leaves_[leaf].end; ++e) {
          if (visit(e)) return true;
        }
        ++leaf;
        continue;
      }
      std::size_t level = 0;
      std::size_t node = leaf;
      while (node % 2 == 0 && level + 1 < levels && skip(boxes.at(level + 1, node / 2))) {
        node /= 2;
        ++level;
      }
      leaf = (node + 1) << level;
    }
    return false;
  }

 private:
  void order_rings(std::size_t begin, std::size_t end, const std::vector<Box>& ring_boxes);

  std::vector<Box> boxes_;
  std::vector<std::size_t> first_;
  std::size_t levels_ = 0;
  std::vector<Range> leaves_;
  std::vector<Range> leaves_of_ring_;
  std::size_t first_ring_ = 0;
  std::vector<std::uint32_t> ring_order_;
};

/// A node of the first operand's tree and one of the second's.
struct BoxPair {
  std::uint32_t level_p, node_p, level_q, node_q;
};

/// Both operands' trees, and the memory to go through pairs of their nodes.
struct BoxTrees {
  BoxTree tree[2];
  std::vector<BoxTree::Box> ring_boxes;  ///< by ring of both operands
  std::vector<std::size_t> outer_rings;  ///< indices of both operands' outer rings

  void build(const Operands& operands, Cancellation& cancellation);
  /// Whether visit(leaf of P, leaf of Q) holds for two leaves whose boxes in P and x − Q may meet.
  /// x is within `doubt` of `at`. near_edges(edges, box) tells whether edges of a leaf may come near
  /// a smaller box. O(log n) for each pair of leaves that come near.
  template <class Near, class Visit>
  [[nodiscard]] bool any_near(const Vec<double>& at, double doubt, Cancellation& cancellation,
                              std::vector<BoxPair>& memory, Near near_edges, Visit visit) const;

  std::vector<BoxPair> stack;
};

/// Whether a box of P and one of x − Q may meet. x is within `doubt` of `at`.
[[nodiscard]] inline bool may_meet(const BoxTree::Box& p, const BoxTree::Box& q,
                                   const Vec<double>& at, double doubt) {
  return p.x1 + doubt >= at.x - q.x1 && at.x - q.x0 + doubt >= p.x0 &&
         p.y1 + doubt >= at.y - q.y1 && at.y - q.y0 + doubt >= p.y0;
}

/// Returns half of a box's circumference.
[[nodiscard]] inline double size_of(const BoxTree::Box& box) {
  return box.x1 - box.x0 + (box.y1 - box.y0);
}

template <class Near, class Visit>
bool BoxTrees::any_near(const Vec<double>& at, double doubt, Cancellation& cancellation,
                        std::vector<BoxPair>& memory, Near near_edges, Visit visit) const {
  const auto& [p, q] = tree;
  const auto top = [](const BoxTree& t) { return static_cast<std::uint32_t>(t.levels() - 1); };
  const BoxTree::Boxes of_p = p.boxes();
  const BoxTree::Boxes of_q = q.boxes();
  memory.assign(1, {top(p), 0, top(q), 0});
  while (!memory.empty()) {
    const BoxPair pair = memory.back();
    memory.pop_back();
    const BoxTree::Box& box_p = of_p.at(pair.level_p, pair.node_p);
    const BoxTree::Box& box_q = of_q.at(pair.level_q, pair.node_q);
    if (!may_meet(box_p, box_q, at, doubt)) continue;
    if (pair.level_p == 0 && pair.level_q == 0) {
      if (visit(pair.node_p, pair.node_q)) return true;
      continue;
    }
    cancellation.check(2 + BoxTree::kLeafEdges);  // for the two pairs that are pushed, and a leaf
    const bool p_is_larger = size_of(box_p) >= size_of(box_q);
    if (p_is_larger ? pair.level_p == 0 && !near_edges(p.edges_of(pair.node_p), box_q)
                    : pair.level_q == 0 && !near_edges(q.edges_of(pair.node_q), box_p)) {
      continue;
    }
    // The larger box is divided first: one leaf of a large operand may be near all of a small one.
    const bool split_p = pair.level_q == 0 || (pair.level_p != 0 && p_is_larger);
    const BoxTree& split = split_p ? p : q;
    const std::uint32_t level = (split_p ? pair.level_p : pair.level_q) - 1;
    const std::uint32_t child = 2 * (split_p ? pair.node_p : pair.node_q);
    for (std::uint32_t node = child; node < std::min<std::size_t>(child + 2, split.nodes(level));
         ++node) {
      memory.push_back(split_p ? BoxPair{level, node, pair.level_q, pair.node_q}
                               : BoxPair{pair.level_p, pair.node_p, level, node});
    }
  }
  return false;
}

/// Tells whether edges of P may come near a box of x − Q, or edges of x − Q near a box of P. Lines of
/// long edges tell more than the edges' box.
class EdgesNearBox {
 public:
  /// x is within `doubt` of `at`.
  EdgesNearBox(const Operands& operands, const RoundingBounds& bounds, const Vec<double>& at,
               double doubt)
      : sites_(operands.sites), bounds_(bounds), at_(at), doubt_(doubt) {}
  bool operator()(const BoxTree::Range& edges, const BoxTree::Box& box) const {
    const auto& [x, y, dx, dy, next] = sites_;
    const double to_x = at_.x - (box.x0 + box.x1) / 2;
    const double to_y = at_.y - (box.y0 + box.y1) / 2;
    const double width = (box.x1 - box.x0) / 2;
    const double height = (box.y1 - box.y0) / 2;
    for (SiteId e = edges.begin; e < edges.end; ++e) {
      const double left = dx[e] * (to_y - y[e]);
      const double right = dy[e] * (to_x - x[e]);
      const double reach = std::abs(dx[e]) * height + std::abs(dy[e]) * width +
                           bounds_.cross_bound({dx[e], dy[e]}, left, right, doubt_);
      if (!(std::abs(left - right) > reach)) return true;
    }
    return false;
  }

 private:
  const ApproximateSites& sites_;
  const RoundingBounds& bounds_;
  Vec<double> at_;
  double doubt_;
};

/// Decides exactly for probes x whether P meets x − Q.
///
/// A probe is in general position. So the two sets meet if and only if two edges cross, or a
/// polygon of one lies inside the other. Edge e of P crosses edge f of x − Q if and only if x lies
/// in the parallelogram e ⊕ f. The sides of four convolution lines on which x lies decide that.
class CollisionTest {
 public:
  /// `stack` is memory for one thread.
  CollisionTest(const Operands& operands, const BoxTrees& trees, std::vector<BoxPair>& stack,
                Predicates& predicates)
      : o_(operands), trees_(trees), stack_(stack), predicates_(predicates) {}
  [[nodiscard]] bool meets(const Probe& probe);

 private:
  [[nodiscard]] bool leaves_cross(std::size_t leaf_p, std::size_t leaf_q);
  [[nodiscard]] BoxTree::Box box_of(SiteId e) const;
  [[nodiscard]] bool edges_cross(SiteId e, SiteId f);
  [[nodiscard]] bool one_inside_other();
  [[nodiscard]] bool outside(const BoxTree::Box& box, SiteId other) const;
  [[nodiscard]] bool passes_odd_times(SiteId other, BoxTree::Range leaves);
  [[nodiscard]] bool inside_operand(SiteId other, std::size_t first_ring, std::size_t last_ring);

  const Operands& o_;
  const BoxTrees& trees_;
  std::vector<BoxPair>& stack_;
  Predicates& predicates_;
  Probe probe_{};
  Vec<double> at_{};
  double doubt_ = 0;
};

}  // namespace minksum

#include "sum/filters/collision.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace minksum {

/// Divides the rings [begin, end) of the order at medians, until each is alone.
void BoxTree::order_rings(std::size_t begin, std::size_t end, const std::vector<Box>& ring_boxes) {
  if (end - begin < 3) return;
  const auto box_of = [&](std::uint32_t ring) -> const Box& { return ring_boxes[ring]; };
  const auto x = [&](std::uint32_t ring) { return box_of(ring).x0 + box_of(ring).x1; };
  const auto y = [&](std::uint32_t ring) { return box_of(ring).y0 + box_of(ring).y1; };
  const auto at = [&](std::size_t i) {
    return ring_order_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  Vec<double> low{x(ring_order_[begin]), y(ring_order_[begin])};
  Vec<double> high = low;
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t ring = ring_order_[i];
    low = {std::min(low.x, x(ring)), std::min(low.y, y(ring))};
    high = {std::max(high.x, x(ring)), std::max(high.y, y(ring))};
  }
  const bool by_x = high.x - low.x >= high.y - low.y;
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return by_x ? x(a) < x(b) : y(a) < y(b);
  });
  order_rings(begin, middle, ring_boxes);
  order_rings(middle, end, ring_boxes);
}

void BoxTree::build(const Operands& o, int operand, const std::vector<Box>& ring_boxes) {
  first_ring_ = operand == 0 ? 0 : o.first_rings;
  const std::size_t count = (operand == 0 ? o.first_rings : o.rings.size()) - first_ring_;
  ring_order_.resize(count);
  std::iota(ring_order_.begin(), ring_order_.end(), static_cast<std::uint32_t>(first_ring_));
  order_rings(0, count, ring_boxes);
  leaves_of_ring_.resize(count);
  leaves_.clear();
  boxes_.clear();
  first_.assign(1, 0);
  const auto& [x, y, dx, dy, next] = o.sites;
  for (const std::uint32_t r : ring_order_) {
    const auto first_leaf = static_cast<std::uint32_t>(leaves_.size());
    for (SiteId e = o.rings[r].begin; e < o.rings[r].end;) {
      const SiteId end = e + std::min(kLeafEdges, o.rings[r].end - e);
      leaves_.push_back({e, end});
      Box box{x[e], y[e], x[e], y[e]};
      for (; e < end; ++e) box.add({x[next[e]], y[next[e]], x[next[e]], y[next[e]]});
      boxes_.push_back(box);
    }
    leaves_of_ring_[r - first_ring_] = {first_leaf, static_cast<std::uint32_t>(leaves_.size())};
  }
  first_.push_back(boxes_.size());
  for (levels_ = 1; first_[levels_] - first_[levels_ - 1] > 1; ++levels_) {
    for (std::size_t i = first_[levels_ - 1]; i < first_[levels_]; i += 2) {
      Box box = boxes_[i];
      if (i + 1 < first_[levels_]) box.add(boxes_[i + 1]);
      boxes_.push_back(box);
    }
    first_.push_back(boxes_.size());
  }
}

void BoxTrees::build(const Operands& o, Cancellation& cancellation) {
  cancellation.check(2 * o.size());
  ring_boxes.clear();
  outer_rings.clear();
  for (const OperandRing& ring : o.rings) {
    if (!ring.is_hole()) outer_rings.push_back(ring_boxes.size());
    ring_boxes.push_back(box_of(o.sites, ring));
  }
  for (const int operand : {0, 1}) tree[operand].build(o, operand, ring_boxes);
}

bool CollisionTest::meets(const Probe& probe) {
  probe_ = probe;
  at_ = predicates_.position(probe);
  const RoundingBounds& bounds = predicates_.bounds();
  doubt_ = 4 * (bounds.position + bounds.magnitude * 0x1p-49);
  const auto cross = [this](std::size_t p, std::size_t q) { return leaves_cross(p, q); };
  return trees_.any_near(at_, doubt_, predicates_.cancellation(), stack_,
                         EdgesNearBox(o_, bounds, at_, doubt_), cross) ||
         one_inside_other();
}

bool CollisionTest::leaves_cross(std::size_t leaf_p, std::size_t leaf_q) {
  const BoxTree& p = trees_.tree[0];
  const BoxTree& q = trees_.tree[1];
  predicates_.cancellation().check(BoxTree::kLeafEdges * BoxTree::kLeafEdges);
  const BoxTree::Range of_p = p.edges_of(leaf_p);
  const BoxTree::Range of_q = q.edges_of(leaf_q);
  const BoxTree::Box& box_q = q.box(0, leaf_q);
  for (SiteId e = of_p.begin; e < of_p.end; ++e) {
    const BoxTree::Box box_e = box_of(e);
    if (!may_meet(box_e, box_q, at_, doubt_)) continue;
    for (SiteId f = of_q.begin; f < of_q.end; ++f) {
      if (may_meet(box_e, box_of(f), at_, doubt_) && edges_cross(e, f)) return true;
    }
  }
  return false;
}

BoxTree::Box CollisionTest::box_of(SiteId e) const {
  const auto& [x, y, dx, dy, next] = o_.sites;
  const auto [x0, x1] = std::minmax(x[e], x[next[e]]);
  const auto [y0, y1] = std::minmax(y[e], y[next[e]]);
  return {x0, y0, x1, y1};
}

/// Whether x lies in the open parallelogram e ⊕ f, that is, between its two lines along e and
/// between its two lines along f.
bool CollisionTest::edges_cross(SiteId e, SiteId f) {
  const auto& next = o_.sites.next;
  const auto side = [&](SiteId edge, SiteId a, SiteId b) {
    return predicates_.orientation(edge, sum_vertex(a, b), probe_, at_);
  };
  return side(e, e, f) != side(e, e, next[f]) && side(f, e, f) != side(f, next[e], f);
}

bool CollisionTest::one_inside_other() {
  const std::size_t middle = o_.first_rings;
  return std::any_of(trees_.outer_rings.begin(), trees_.outer_rings.end(), [&](std::size_t r) {
    const SiteId site = o_.rings[r].begin;
    return r < middle ? inside_operand(site, middle, o_.rings.size())
                      : inside_operand(site, 0, middle);
  });
}

/// Whether x − `other` certainly lies outside a box of the other operand.
bool CollisionTest::outside(const BoxTree::Box& box, SiteId other) const {
  const double x = at_.x - o_.sites.x[other];
  const double y = at_.y - o_.sites.y[other];
  return x < box.x0 - doubt_ || x > box.x1 + doubt_ || y < box.y0 - doubt_ || y > box.y1 + doubt_;
}

/// Whether a ray from x − `other` to the right passes an odd number of the edges of these leaves,
/// which must be whole rings. O(log n) for each edge that the ray comes near.
bool CollisionTest::passes_odd_times(SiteId other, BoxTree::Range leaves) {
  const BoxTree& tree = trees_.tree[1 - o_.operand_of(other)];
  const Vec<double> at{at_.x - o_.sites.x[other], at_.y - o_.sites.y[other]};
  Cancellation& cancellation = predicates_.cancellation();
  const auto misses = [&](const BoxTree::Box& box) {
    cancellation.check(BoxTree::kLeafEdges);  // for the edges of a leaf, too
    return box.y1 < at.y - doubt_ || box.y0 > at.y + doubt_ || box.x1 < at.x - doubt_;
  };
  const auto above = [&](SiteId v) {
    return predicates_.compare_y(probe_, at_, sum_vertex(v, other)) == kNegative;
  };
  bool odd = false;
  tree.any_edge(leaves, misses, [&](SiteId e) {
    const SiteId f = o_.sites.next[e];
    const double y0 = o_.sites.y[e];
    const double y1 = o_.sites.y[f];
    if (std::max(y0, y1) < at.y - doubt_ || std::min(y0, y1) > at.y + doubt_) return false;
    // An edge that goes up has the point on its left if it passes on the right of the point.
    const bool f_above = above(f);
    if (above(e) != f_above &&
        (predicates_.orientation(e, sum_vertex(e, other), probe_, at_) == kPositive) == f_above) {
      odd = !odd;
    }
    return false;
  });
  return odd;
}

/// Whether x − `other` lies in the other operand, whose rings are [first_ring, last_ring). The
/// parity along a ray to the right decides.
bool CollisionTest::inside_operand(SiteId other, std::size_t first_ring, std::size_t last_ring) {
  const BoxTree& tree = trees_.tree[1 - o_.operand_of(other)];
  if (outside(tree.whole(), other)) return false;
  if (!o_.holes_filled || o_.connected) return passes_odd_times(other, tree.leaves());
  // Polygons are taken one by one, because filled holes may contain further polygons.
  bool inside = false;
  predicates_.cancellation().check(last_ring - first_ring);
  for (std::size_t r = first_ring; r < last_ring; ++r) {
    const OperandRing& ring = o_.rings[r];
    if (!ring.is_hole() && inside) return true;
    if (!outside(trees_.ring_boxes[r], other)) inside ^= passes_odd_times(other, tree.leaves_of(r));
  }
  return inside;
}

}  // namespace minksum

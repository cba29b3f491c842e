#include "sum/tight/overlap_test.hpp"

#include <algorithm>

namespace minksum {

OverlapTest::OverlapTest(const Operands& operands, BoxTrees& trees, Predicates& predicates,
                         TightScratch& scratch)
    : o_(operands), trees_(trees), predicates_(predicates), scratch_(scratch) {
  scratch_.ring_of.resize(o_.size());
  for (std::uint32_t r = 0; r < o_.rings.size(); ++r) {
    for (SiteId v = o_.rings[r].begin; v < o_.rings[r].end; ++v) scratch_.ring_of[v] = r;
  }
  scratch_.met.assign(o_.rings.size(), 0);
  for (const int operand : {0, 1}) {
    find_touching_rings(o_, operand, trees_.tree[operand], predicates_, scratch_.touching[operand]);
  }
}

bool OverlapTest::overlaps(const ContactPosition& x) {
  x_ = x;
  ++number_;
  const RoundingBounds& bounds = predicates_.bounds();
  doubt_ = x.error + 4 * (bounds.position + bounds.magnitude * 0x1p-49);
  const auto overlap = [this](std::size_t p, std::size_t q) { return leaves_overlap(p, q); };
  return trees_.any_near(x_.at, doubt_, predicates_.cancellation(), trees_.stack,
                         EdgesNearBox(o_, bounds, x_.at, doubt_), overlap) ||
         a_ring_is_inside(0) || a_ring_is_inside(1);
}

bool OverlapTest::near(const BoxTree::Box& p, const BoxTree::Box& q) const {
  return may_meet(p, q, x_.at, doubt_);
}

template <class Visit>
bool OverlapTest::any_part(SiteId edge, int operand, Visit visit) const {
  const TouchingRings& touching = scratch_.touching[operand];
  EdgePart part{edge, edge, o_.sites.next[edge],
                touching.last_edge.empty() ? o_.previous[edge] : touching.last_edge[edge]};
  auto cut = std::lower_bound(touching.cuts.begin(), touching.cuts.end(), edge,
                              [](const EdgeCut& c, SiteId e) { return c.edge < e; });
  for (; cut != touching.cuts.end() && cut->edge == edge; ++cut) {
    if (visit(EdgePart{edge, part.from, cut->at, part.last})) return true;
    part.from = cut->at;
    part.last = cut->last;
  }
  return visit(part);
}

bool OverlapTest::leaves_overlap(std::size_t leaf_p, std::size_t leaf_q) {
  const BoxTree& p = trees_.tree[0];
  const BoxTree& q = trees_.tree[1];
  predicates_.cancellation().check(2 * BoxTree::kLeafEdges * BoxTree::kLeafEdges);
  for (SiteId e = p.edges_of(leaf_p).begin; e < p.edges_of(leaf_p).end; ++e) {
    for (SiteId f = q.edges_of(leaf_q).begin; f < q.edges_of(leaf_q).end; ++f) {
      const bool overlap = any_part(e, 0, [&](const EdgePart& of_p) {
        return any_part(f, 1, [&](const EdgePart& of_q) { return parts_overlap(of_p, of_q); });
      });
      if (overlap) return true;
    }
  }
  return false;
}

bool OverlapTest::parts_overlap(const EdgePart& e, const EdgePart& f) {
  const Sign f_from = side(e.edge, f.from);
  const Sign f_to = side(e.edge, f.to);
  if (f_from == f_to && f_from != kZero) return false;
  const Sign e_from = side(f.edge, e.from);
  const Sign e_to = side(f.edge, e.to);
  if (e_from == e_to && e_from != kZero) return false;
  if (f_from == kZero && f_to == kZero) return overlap_on_line(e, f);
  if (f_from != kZero && f_to != kZero && e_from != kZero && e_to != kZero) return true;
  touch(e, f);
  // A corner belongs to the part that starts with it. A part that ends here is left to the part
  // that goes on.
  if (f_from == kZero) {
    if (e_to == kZero) return false;
    return meet(e_from == kZero ? corner(e) : half_plane(e), corner(f));
  }
  return e_from == kZero && f_to != kZero && meet(corner(e), half_plane(f));
}

bool OverlapTest::overlap_on_line(const EdgePart& e, const EdgePart& f) {
  const Axis axis = predicates_.component(e.edge, Axis::kX) == kZero ? Axis::kY : Axis::kX;
  const Sign forward = predicates_.component(e.edge, axis);
  // These tell where the ends of f are along e, seen from the ends of e.
  const Sign from_from = forward * compare(e.from, f.from, axis);
  const Sign from_to = forward * compare(e.from, f.to, axis);
  const Sign to_from = forward * compare(e.to, f.from, axis);
  const Sign to_to = forward * compare(e.to, f.to, axis);
  if ((from_from == kNegative && from_to == kNegative) ||
      (to_from == kPositive && to_to == kPositive)) {
    return false;
  }
  touch(e, f);
  if (from_from == kZero) return meet(corner(e), corner(f));
  if (from_from == kPositive && to_from == kNegative && meet(half_plane(e), corner(f))) return true;
  return from_from == -from_to && meet(corner(e), half_plane(f));
}

OverlapTest::Arc OverlapTest::corner(const EdgePart& part) const {
  const DirectionRank out = o_.rank[part.edge];
  const DirectionRank in = o_.rank[part.last];
  return o_.operand_of(part.edge) == 0 ? Arc{o_.place[out], o_.reverse_place[in]}
                                       : Arc{o_.reverse_place[out], o_.place[in]};
}
OverlapTest::Arc OverlapTest::half_plane(const EdgePart& part) const {
  const DirectionRank rank = o_.rank[part.edge];
  return o_.operand_of(part.edge) == 0 ? Arc{o_.place[rank], o_.reverse_place[rank]}
                                       : Arc{o_.reverse_place[rank], o_.place[rank]};
}
bool OverlapTest::meet(const Arc& a, const Arc& b) const {
  return o_.turn(a.begin, b.begin) < o_.turn(a.begin, a.end) ||
         o_.turn(b.begin, a.begin) < o_.turn(b.begin, b.end);
}

Sign OverlapTest::side(SiteId edge, SiteId vertex) {
  if (x_.node != nullptr) {
    return predicates_.orientation({edge, vertex}, x_.node->point, x_.at, x_.error);
  }
  const SumVertex v = sum_vertex(edge, vertex);
  return predicates_.side(edge, v, x_.at, x_.error, [&] {
    return predicates_.kernel().probe_orientation(edge, v, x_.probe);
  });
}

Sign OverlapTest::compare(SiteId a, SiteId b, Axis axis) {
  const SumVertex v = sum_vertex(a, b);
  return predicates_.compare(x_.at, x_.error, v, axis, [&] {
    const ExactKernel& kernel = predicates_.kernel();
    return x_.node == nullptr ? kernel.probe_compare(x_.probe, v, axis)
                              : kernel.compare(x_.node->point, {false, {}, {}, v}, axis);
  });
}

bool OverlapTest::a_ring_is_inside(int operand) {
  const std::size_t first = operand == 0 ? 0 : o_.first_rings;
  const std::size_t last = operand == 0 ? o_.first_rings : o_.rings.size();
  constexpr std::size_t kFew = 8;
  if (last - first <= kFew) {
    for (std::size_t r = first; r < last; ++r) {
      if (is_inside(r, 1 - operand)) return true;
    }
    return false;
  }
  // A ring inside the other operand has all its edges in that operand's box.
  const BoxTree::Box& all = trees_.tree[1 - operand].whole();
  const auto misses = [&](const BoxTree::Box& box) {
    predicates_.cancellation().check();
    return operand == 0 ? !near(box, all) : !near(all, box);
  };
  const BoxTree& tree = trees_.tree[operand];
  return tree.any_edge(tree.leaves(), misses, [&](SiteId e) {
    predicates_.cancellation().check();
    const std::uint32_t r = scratch_.ring_of[e];
    return e == o_.rings[r].begin && is_inside(r, 1 - operand);
  });
}

/// Whether a ring touches nothing and is inside the given operand, which is not its own.
bool OverlapTest::is_inside(std::size_t ring, int operand) {
  if (scratch_.met[ring] == number_) return false;
  const BoxTree::Box& all = trees_.tree[operand].whole();
  const BoxTree::Box& box = trees_.ring_boxes[ring];
  return (operand == 0 ? near(all, box) : near(box, all)) &&
         has_inside(operand, o_.rings[ring].begin);
}

/// Whether x − `vertex` is inside an operand, by parity along a ray to the right. The point must be
/// on no edge. (Polygons do not overlap, see `fill_holes`.)
bool OverlapTest::has_inside(int operand, SiteId vertex) {
  const BoxTree& tree = trees_.tree[operand];
  const Vec<double> at{x_.at.x - o_.sites.x[vertex], x_.at.y - o_.sites.y[vertex]};
  const auto misses = [&](const BoxTree::Box& box) {
    predicates_.cancellation().check();
    return box.y1 < at.y - doubt_ || box.y0 > at.y + doubt_ || box.x1 < at.x - doubt_;
  };
  const auto above = [&](SiteId v) { return compare(v, vertex, Axis::kY) == kNegative; };
  bool odd = false;
  tree.any_edge(tree.leaves(), misses, [&](SiteId e) {
    predicates_.cancellation().check();
    const bool goes_up = above(o_.sites.next[e]);
    // An edge that goes up has the point on its left if it passes on the right of the point.
    if (above(e) != goes_up && (side(e, vertex) == kPositive) == goes_up) odd = !odd;
    return false;
  });
  return odd;
}

}  // namespace minksum

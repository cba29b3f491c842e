// Step 5 of the signed method: links boundary pieces into rings, polygons and the region.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "exact/fraction.hpp"
#include "minksum/region.hpp"
#include "region/rational_access.hpp"
#include "second/signed_convolution/arrangement.hpp"
#include "second/signed_convolution/broken.hpp"
#include "second/signed_convolution/geometry.hpp"
#include "second/signed_convolution/operands.hpp"
#include "second/signed_convolution/winding.hpp"

namespace minksum::signed_sum {

/// A simple ring of boundary pieces, with the sum on its left.
struct BoundaryRing {
  std::vector<HalfEdge> edges;     ///< all pieces, from the lexicographically smallest node
  std::vector<HalfEdge> vertices;  ///< those that start at a vertex which is not straight
  bool outer = false;              ///< counter-clockwise
  std::size_t walk = 0;            ///< index of the closed walk from which it was split
};

/// A closed walk along the boundary of one component of the sum's interior.
struct BoundaryTrace {
  NodeId leftmost = 0;        ///< its lexicographically smallest node
  std::size_t outer = kNone;  ///< its only outer ring, if it has one
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
};

struct BoundaryRings {
  std::vector<BoundaryRing> rings;
  std::vector<BoundaryTrace> walks;
};

/// An outer ring and its holes, by index.
struct BoundaryPolygon {
  std::size_t outer = 0;
  std::vector<std::size_t> holes;
};

template <class N>
class RingBuilder {
 public:
  RingBuilder(const Geometry<N>& geometry, const Arrangement& arrangement,
              const InsideFlags& inside)
      : geometry_(geometry),
        cancellation_(geometry.cancellation()),
        arrangement_(arrangement),
        inside_(inside) {}

  BoundaryRings run() {
    used_.assign(arrangement_.half_edge_count(), false);
    assign_in_pieces(place_of_node_, arrangement_.node_count(), kNowhere, cancellation_);
    for (HalfEdge h = 0; h < used_.size(); ++h) {
      cancellation_.check();
      if (!used_[h] && is_boundary(inside_, h)) walk_from(h);
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

  // Returns the next boundary piece. The sum's interior lies left of h. Turning clockwise from h's
  // reverse sweeps that interior, up to the first boundary piece.
  [[nodiscard]] HalfEdge next_on_boundary(HalfEdge h) const {
    const HalfEdge back = twin(h);
    HalfEdge next = arrangement_.clockwise(back);
    while (!is_boundary(inside_, next)) {
      cancellation_.check();
      if (next == back) broken("the sum's boundary ends at a node");
      next = arrangement_.clockwise(next);
    }
    return next;
  }

  // Follows a walk. Whenever it comes back to a node, the pieces since then are a ring of their
  // own.
  void walk_from(HalfEdge start) {
    const std::size_t walk = result_.walks.size();
    result_.walks.push_back({arrangement_.origin(start), BoundaryTrace::kNone});
    std::vector<HalfEdge> path;
    HalfEdge h = start;
    do {
      if (used_[h]) broken("two walks along the sum's boundary share a piece");
      used_[h] = true;
      place_of_node_[arrangement_.origin(h)] = static_cast<std::uint32_t>(path.size());
      path.push_back(h);
      const NodeId end = arrangement_.origin(twin(h));
      if (place_of_node_[end] != kNowhere) split_off(path, place_of_node_[end], walk);
      h = next_on_boundary(h);
    } while (h != start);
    if (!path.empty()) broken("a walk along the sum's boundary is not closed");
  }

  void split_off(std::vector<HalfEdge>& path, std::size_t from, std::size_t walk) {
    cancellation_.check(2 * (path.size() - from));
    BoundaryRing ring;
    ring.walk = walk;
    ring.edges.assign(path.begin() + static_cast<std::ptrdiff_t>(from), path.end());
    path.resize(from);
    for (const HalfEdge h : ring.edges) place_of_node_[arrangement_.origin(h)] = kNowhere;
    start_at_leftmost(ring);
    keep_corners(ring);
    NodeId& leftmost = result_.walks[walk].leftmost;
    const NodeId first = arrangement_.origin(ring.edges.front());
    if (first != leftmost && geometry_.compare_xy(first, leftmost) < 0) leftmost = first;
    ring.outer = turn(ring.edges.back(), ring.edges.front()) > 0;
    if (ring.outer) {
      if (result_.walks[walk].outer != BoundaryTrace::kNone) {
        broken("a component of the sum has two outer rings");
      }
      result_.walks[walk].outer = result_.rings.size();
    }
    result_.rings.push_back(std::move(ring));
  }

  void start_at_leftmost(BoundaryRing& ring) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring.edges.size(); ++i) {
      cancellation_.check();
      const NodeId a = arrangement_.origin(ring.edges[i]);
      if (geometry_.compare_xy(a, arrangement_.origin(ring.edges[best])) < 0) best = i;
    }
    std::rotate(ring.edges.begin(), ring.edges.begin() + static_cast<std::ptrdiff_t>(best),
                ring.edges.end());
  }

  void keep_corners(BoundaryRing& ring) const {
    HalfEdge previous = ring.edges.back();
    for (const HalfEdge h : ring.edges) {
      if (turn(previous, h) != 0) ring.vertices.push_back(h);
      previous = h;
    }
    if (ring.vertices.size() < 3) broken("a ring of the sum has no area");
  }

  [[nodiscard]] int turn(HalfEdge a, HalfEdge b) const {
    cancellation_.check(geometry_.work() / 4 + 1);
    return sign_of(Geometry<N>::cross(direction(a), direction(b)));
  }
  [[nodiscard]] typename Geometry<N>::Vector direction(HalfEdge h) const {
    const Piece& piece = arrangement_.pieces[h >> 1];
    const auto d = geometry_.direction(piece.segment);
    if (piece.along_segment == ((h & 1U) == 0)) return d;
    return {-d.x, -d.y};
  }

  const Geometry<N>& geometry_;
  Cancellation& cancellation_;
  const Arrangement& arrangement_;
  const InsideFlags& inside_;
  std::vector<bool> used_;
  std::vector<std::uint32_t> place_of_node_;  // by node: index in the path of its half-edge
  BoundaryRings result_;
};

/// Finds the polygon of each hole.
template <class N>
class PolygonBuilder {
 public:
  PolygonBuilder(const Geometry<N>& geometry, const Arrangement& arrangement,
                 const BoundaryRings& boundary)
      : geometry_(geometry),
        cancellation_(geometry.cancellation()),
        arrangement_(arrangement),
        boundary_(boundary) {}

  std::vector<BoundaryPolygon> run() {
    std::vector<BoundaryPolygon> polygons;
    std::vector<std::size_t> polygon_of(boundary_.rings.size());
    for (std::size_t i = 0; i < boundary_.rings.size(); ++i) {
      if (!boundary_.rings[i].outer) continue;
      polygon_of[i] = polygons.size();
      polygons.push_back({i, {}});
      outers_.push_back(describe(i));
    }
    std::vector<std::size_t> outer_of_walk;
    for (const BoundaryTrace& walk : boundary_.walks) {
      outer_of_walk.push_back(walk.outer != BoundaryTrace::kNone ? walk.outer
                                                                 : around(walk.leftmost));
    }
    for (std::size_t i = 0; i < boundary_.rings.size(); ++i) {
      const BoundaryRing& ring = boundary_.rings[i];
      if (!ring.outer) polygons[polygon_of[outer_of_walk[ring.walk]]].holes.push_back(i);
    }
    put_in_order(polygons);
    return polygons;
  }

 private:
  struct OuterRing {
    std::size_t ring;
    Key min;
    Key max;
  };

  [[nodiscard]] OuterRing describe(std::size_t index) const {
    const BoundaryRing& ring = boundary_.rings[index];
    const Key& first = geometry_.key(arrangement_.origin(ring.vertices.front()));
    OuterRing outer{index, first, first};
    for (const HalfEdge h : ring.vertices) {
      cancellation_.check();
      const Key& key = geometry_.key(arrangement_.origin(h));
      outer.min = {std::min(outer.min.x, key.x), std::min(outer.min.y, key.y)};
      outer.max = {std::max(outer.max.x, key.x), std::max(outer.max.y, key.y)};
    }
    return outer;
  }

  // Returns the innermost outer ring around a walk of holes. The point just left of the walk's
  // leftmost node is in the sum's interior. So it is on no ring, and in the same component as the
  // holes.
  [[nodiscard]] std::size_t around(NodeId node) const {
    const Key& key = geometry_.key(node);
    std::size_t best = BoundaryTrace::kNone;
    for (const OuterRing& outer : outers_) {
      cancellation_.check();
      if (key.x < outer.min.x || outer.max.x < key.x) continue;
      if (key.y < outer.min.y || outer.max.y < key.y) continue;
      if (!holds_left_of(outer.ring, node)) continue;
      if (best == BoundaryTrace::kNone || doubled_area(outer.ring) < doubled_area(best)) {
        best = outer.ring;
      }
    }
    if (best == BoundaryTrace::kNone) broken("a hole of the sum is in no outer ring");
    return best;
  }

  // Tells whether a ring winds around the point just left of a node, by a ray straight down.
  [[nodiscard]] bool holds_left_of(std::size_t ring, NodeId node) const {
    bool odd = false;
    for (const HalfEdge h : boundary_.rings[ring].edges) {
      cancellation_.check();
      const NodeId a = arrangement_.origin(h);
      const NodeId b = arrangement_.origin(twin(h));
      const bool rightward = geometry_.compare_x(a, node) < 0;
      if (rightward == (geometry_.compare_x(b, node) < 0)) continue;
      odd ^= is_above(h, rightward ? a : b, rightward ? b : a, rightward, node);
    }
    return odd;
  }

  // Tells whether the point just left of `node` is above the half-edge between `left` and `right`.
  [[nodiscard]] bool is_above(HalfEdge h, NodeId left, NodeId right, bool rightward,
                              NodeId node) const {
    if (right == node) return geometry_.compare_y(left, node) < 0;
    const Piece& piece = arrangement_.pieces[h >> 1];
    const int side = geometry_.side_of_node(piece.segment, node);
    if (side == 0) broken("a ring of the sum runs through the inside of another's piece");
    const bool segment_rightward = (piece.along_segment == ((h & 1U) == 0)) == rightward;
    return (side > 0) == segment_rightward;
  }

  [[nodiscard]] Fraction doubled_area(std::size_t ring) const {
    const auto big = [](const auto& n) { return BigInteger(n); };
    Fraction sum;
    const std::vector<HalfEdge>& vertices = boundary_.rings[ring].vertices;
    auto a = geometry_.exact(arrangement_.origin(vertices.back()));
    for (const HalfEdge h : vertices) {
      cancellation_.check(work_of_decision(bit_length(sum.denominator())));
      const auto b = geometry_.exact(arrangement_.origin(h));
      const BigInteger cross = big(a.x) * big(b.y) - big(a.y) * big(b.x);
      sum = (sum + Fraction(cross, big(a.d) * big(b.d))).reduced();
      a = b;
    }
    return sum;
  }

  // Orders rings by first vertices, and by second vertices where both start at the same node.
  [[nodiscard]] bool ring_less(std::size_t a, std::size_t b) const {
    cancellation_.check();
    for (std::size_t i = 0; i < 2; ++i) {
      const int order = geometry_.compare_xy(arrangement_.origin(boundary_.rings[a].vertices[i]),
                                             arrangement_.origin(boundary_.rings[b].vertices[i]));
      if (order != 0) return order < 0;
    }
    return false;
  }
  void put_in_order(std::vector<BoundaryPolygon>& polygons) const {
    for (BoundaryPolygon& polygon : polygons) {
      std::sort(polygon.holes.begin(), polygon.holes.end(),
                [&](std::size_t a, std::size_t b) { return ring_less(a, b); });
    }
    std::sort(polygons.begin(), polygons.end(),
              [&](const BoundaryPolygon& a, const BoundaryPolygon& b) {
                return ring_less(a.outer, b.outer);
              });
  }

  const Geometry<N>& geometry_;
  Cancellation& cancellation_;
  const Arrangement& arrangement_;
  const BoundaryRings& boundary_;
  std::vector<OuterRing> outers_;
};

/// Writes the polygons into `result`, scaled and moved back to the operands' coordinates.
template <class N>
void write_region(const Geometry<N>& geometry, const Arrangement& arrangement,
                  const BoundaryRings& boundary, const std::vector<BoundaryPolygon>& polygons,
                  const IntegerOperands& operands, Region& result) {
  const auto coordinate = [&](const auto& n, const auto& d, const BigInteger& origin) {
    const BigInteger denominator = widen<BigInteger>(d);
    return RationalAccess::make(origin * denominator + widen<BigInteger>(n),
                                denominator * operands.scale);
  };
  const auto write_ring = [&](std::size_t ring) {
    result.begin_ring();
    for (const HalfEdge h : boundary.rings[ring].vertices) {
      const auto point = geometry.exact(arrangement.origin(h));
      geometry.cancellation().check(16 + 4 * geometry.work());
      result.add_vertex(coordinate(point.x, point.d, operands.origin.x),
                        coordinate(point.y, point.d, operands.origin.y));
    }
  };
  for (const BoundaryPolygon& polygon : polygons) {
    result.begin_polygon();
    write_ring(polygon.outer);
    for (const std::size_t hole : polygon.holes) write_ring(hole);
  }
}

}  // namespace minksum::signed_sum

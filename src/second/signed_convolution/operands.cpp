#include "second/signed_convolution/operands.hpp"

#include <algorithm>
#include <numeric>

#include "minksum/error.hpp"
#include "region/common_scale.hpp"
#include "region/fraction_sum.hpp"
#include "region/rational_access.hpp"
#include "region/region_access.hpp"
#include "second/signed_convolution/broken.hpp"

namespace minksum::signed_sum {
namespace {

using ExactRing = std::vector<Point>;
struct ExactPolygon {
  bool is_walk = false;
  std::vector<ExactRing> rings;  // the outer ring first
};

std::vector<ExactPolygon> read(const CallerOperand& given, Cancellation& cancellation) {
  std::vector<ExactPolygon> polygons;
  for (const Polyline& polyline : given.polylines) {
    ExactRing walk(polyline);
    walk.insert(walk.end(), polyline.rbegin() + 1, polyline.rend() - 1);
    polygons.push_back({true, {std::move(walk)}});
  }
  if (given.region == nullptr) return polygons;
  const Region& region = *given.region;
  for (const std::size_t polygon : region.polygons()) {
    std::vector<ExactRing>& rings = polygons.emplace_back().rings;
    for (const std::size_t ring : region.rings_of(polygon)) {
      ExactRing& points = rings.emplace_back();
      for (const std::size_t vertex : region.vertices_of(ring)) {
        cancellation.check(4 + 8 * work_of_product(RegionAccess::bits(region, vertex)));
        points.push_back(region.point(vertex));
      }
    }
  }
  return polygons;
}

BigInteger common_denominator(const std::vector<ExactPolygon>& p,
                              const std::vector<ExactPolygon>& q, Cancellation& cancellation) {
  std::vector<BigInteger> denominators;
  for (const auto* polygons : {&p, &q}) {
    for (const ExactPolygon& polygon : *polygons) {
      for (const ExactRing& ring : polygon.rings) {
        for (const Point& point : ring) {
          cancellation.check();
          denominators.push_back(RationalAccess::denominator(point.x));
          denominators.push_back(RationalAccess::denominator(point.y));
        }
      }
    }
  }
  return least_common_multiple(1, std::move(denominators), cancellation);
}

BigInteger scaled(const Rational& value, const BigInteger& scale, Cancellation& cancellation) {
  return RationalAccess::numerator(value) *
         divided(scale, RationalAccess::denominator(value), cancellation).quotient;
}

BigInteger cross(const IntegerPoint& a, const IntegerPoint& b) { return a.x * b.y - a.y * b.x; }
/// Returns the units of work of such a product.
std::uint64_t work_of_cross(const IntegerPoint& a) {
  return 2 * work_of_product(64 * std::max(a.x.limb_count(), a.y.limb_count()));
}

IntegerPoint edge(const IntegerRing& ring, std::size_t i) {
  const IntegerPoint& a = ring.vertices[i];
  const IntegerPoint& b = ring.vertices[ring.next(i)];
  return {b.x - a.x, b.y - a.y};
}

bool same(const IntegerPoint& a, const IntegerPoint& b) { return a.x == b.x && a.y == b.y; }

void drop_repeated_vertices(std::vector<IntegerPoint>& points) {
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  while (points.size() > 1 && same(points.front(), points.back())) points.pop_back();
}

// In a simple ring, a straight vertex goes straight on. Dropping it keeps the directions of its
// neighbours' edges, so one pass is enough.
void drop_straight_vertices(IntegerRing& ring, Cancellation& cancellation) {
  std::vector<IntegerPoint> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    cancellation.check(work_of_cross(ring.vertices[i]));
    if (cross(edge(ring, ring.previous(i)), edge(ring, i)) != 0) kept.push_back(ring.vertices[i]);
  }
  ring.vertices = std::move(kept);
}

BigInteger doubled_area(const IntegerRing& ring, Cancellation& cancellation) {
  BigInteger sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    cancellation.check(work_of_cross(ring.vertices[i]));
    sum += cross(ring.vertices[i], ring.vertices[ring.next(i)]);
  }
  return sum;
}

IntegerPoint extent_of(const std::vector<IntegerPoint>& points) {
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(),
                          [](const IntegerPoint& a, const IntegerPoint& b) { return a.x < b.x; });
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const IntegerPoint& a, const IntegerPoint& b) { return a.y < b.y; });
  return {right->x - left->x, high->y - low->y};
}

/// Returns the units of work of making a vertex of a ring.
std::uint64_t work_of_vertex(const BigInteger& scale) {
  return 16 + 16 * work_of_product(bit_length(scale) + 64);
}

enum class RingKind { kOuter, kHole, kWalk };

IntegerRing make_ring(const ExactRing& exact, const BigInteger& scale, RingKind kind,
                      Cancellation& cancellation) {
  IntegerRing ring;
  for (const Point& point : exact) {
    cancellation.check(work_of_vertex(scale));
    ring.vertices.push_back(
        {scaled(point.x, scale, cancellation), scaled(point.y, scale, cancellation)});
  }
  if (kind != RingKind::kWalk) {
    drop_repeated_vertices(ring.vertices);
    drop_straight_vertices(ring, cancellation);
    const BigInteger area = doubled_area(ring, cancellation);
    if (ring.size() < 3 || area == 0) broken("an operand has a ring without area");
    if ((area > 0) != (kind == RingKind::kOuter)) {
      std::reverse(ring.vertices.begin(), ring.vertices.end());
    }
  }
  ring.extent = extent_of(ring.vertices);
  // No vertex is straight. At both ends of a walk, its edges are parallel.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    cancellation.check(work_of_cross(ring.vertices[i]));
    ring.convex.push_back(cross(edge(ring, ring.previous(i)), edge(ring, i)) >= 0);
  }
  return ring;
}

std::vector<IntegerPart> make_parts(const std::vector<ExactPolygon>& polygons,
                                    const BigInteger& scale, Cancellation& cancellation) {
  std::vector<IntegerPart> parts;
  for (const auto& [is_walk, rings] : polygons) {
    if (rings.empty()) broken("an operand has a polygon without rings");
    IntegerPart& part = parts.emplace_back();
    part.outer =
        make_ring(rings.front(), scale, is_walk ? RingKind::kWalk : RingKind::kOuter, cancellation);
    for (std::size_t i = 1; i < rings.size(); ++i) {
      part.holes.push_back(make_ring(rings[i], scale, RingKind::kHole, cancellation));
    }
  }
  return parts;
}

std::vector<IntegerRing*> rings_of(std::vector<IntegerPart>& parts) {
  std::vector<IntegerRing*> rings;
  for (IntegerPart& part : parts) {
    rings.push_back(&part.outer);
    for (IntegerRing& hole : part.holes) rings.push_back(&hole);
  }
  return rings;
}

struct DirectedEdge {
  IntegerPoint direction;
  const IntegerRing* ring;
  std::size_t edge;
};

void collect_edges(const IntegerRing& ring, std::vector<DirectedEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({edge(ring, i), &ring, i});
}

bool in_first_half(const IntegerPoint& d) { return d.x > 0 || (d.x == 0 && d.y > 0); }

bool direction_less(const DirectedEdge& a, const DirectedEdge& b) {
  const bool a_first = in_first_half(a.direction);
  if (a_first != in_first_half(b.direction)) return a_first;
  return cross(a.direction, b.direction) > 0;
}

DirectionRank rank_directions(std::vector<IntegerPart>& p, std::vector<IntegerPart>& q,
                              Cancellation& cancellation) {
  std::vector<DirectedEdge> edges;
  std::vector<IntegerRing*> owners;
  std::vector<std::size_t> owner_of;
  for (auto* parts : {&p, &q}) {
    for (IntegerRing* ring : rings_of(*parts)) {
      collect_edges(*ring, edges);
      owners.push_back(ring);
      owner_of.resize(edges.size(), owners.size() - 1);
      ring->directions.resize(ring->size());
    }
  }
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    cancellation.check(2 * work_of_cross(edges[a].direction));
    return direction_less(edges[a], edges[b]);
  });
  DirectionRank rank = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && direction_less(edges[order[i - 1]], edges[order[i]])) ++rank;
    owners[owner_of[order[i]]]->directions[edges[order[i]].edge] = rank;
  }
  return rank + 1;
}

void sort_edges(IntegerRing& ring, Cancellation& cancellation) {
  ring.by_direction.resize(ring.size());
  std::iota(ring.by_direction.begin(), ring.by_direction.end(), 0U);
  std::sort(
      ring.by_direction.begin(), ring.by_direction.end(), [&](std::uint32_t a, std::uint32_t b) {
        cancellation.check();
        return ring.directions[a] != ring.directions[b] ? ring.directions[a] < ring.directions[b]
                                                        : a < b;
      });
}

void check_ring(const IntegerRing& ring, bool counter_clockwise, DirectionRank count) {
  Cancellation nobody;
  const BigInteger area = doubled_area(ring, nobody);
  if (ring.size() < 2 || (area != 0 && (area > 0) != counter_clockwise)) {
    broken("a ring of an operand has the wrong orientation");
  }
  std::size_t ends = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const IntegerPoint in = edge(ring, ring.previous(i));
    const IntegerPoint out = edge(ring, i);
    const BigInteger turn = cross(in, out);
    if (turn == 0 && in.x * out.x + in.y * out.y >= 0) broken("a vertex of an operand is straight");
    ends += turn == 0 ? 1U : 0U;
    if ((turn >= 0) != ring.convex[i]) broken("a vertex of an operand is misjudged");
    if (ring.directions[i] >= count) broken("a direction of an operand has no rank");
  }
  if (ends != (area == 0 ? 2U : 0U)) broken("an operand is neither a polygon nor a polyline");
}

}  // namespace

IntegerOperands make_operands(const CallerOperand& p, const CallerOperand& q,
                              Cancellation& cancellation) {
  const std::vector<ExactPolygon> exact_p = read(p, cancellation);
  const std::vector<ExactPolygon> exact_q = read(q, cancellation);
  IntegerOperands operands;
  operands.scale = common_denominator(exact_p, exact_q, cancellation);
  operands.p = make_parts(exact_p, operands.scale, cancellation);
  operands.q = make_parts(exact_q, operands.scale, cancellation);
  operands.direction_count = rank_directions(operands.p, operands.q, cancellation);
  for (auto* parts : {&operands.p, &operands.q}) {
    for (IntegerRing* ring : rings_of(*parts)) sort_edges(*ring, cancellation);
  }
  return operands;
}

void check(const IntegerOperands& operands) {
  std::vector<DirectedEdge> edges;
  for (const auto* parts : {&operands.p, &operands.q}) {
    for (const IntegerPart& part : *parts) {
      check_ring(part.outer, true, operands.direction_count);
      collect_edges(part.outer, edges);
      for (const IntegerRing& hole : part.holes) {
        check_ring(hole, false, operands.direction_count);
        collect_edges(hole, edges);
      }
    }
  }
  const auto rank = [](const DirectedEdge& e) { return e.ring->directions[e.edge]; };
  std::sort(edges.begin(), edges.end(),
            [&](const DirectedEdge& a, const DirectedEdge& b) { return rank(a) < rank(b); });
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const bool same_rank = rank(edges[i - 1]) == rank(edges[i]);
    if (direction_less(edges[i - 1], edges[i]) == same_rank ||
        direction_less(edges[i], edges[i - 1])) {
      broken("the directions of the operands are not in order");
    }
  }
}

}  // namespace minksum::signed_sum

#include "second/signed_convolution/operands.hpp"

#include <algorithm>
#include <utility>

#include "region/common_scale.hpp"
#include "region/fraction_sum.hpp"
#include "region/rational_access.hpp"
#include "region/region_access.hpp"
#include "second/signed_convolution/broken.hpp"

namespace minksum::signed_sum {
namespace {

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

/// A ring without area is a walk, whose ends are its only straight vertices.
IntegerRing make_ring(const Region& region, std::size_t index, const BigInteger& scale,
                      bool is_hole, Cancellation& cancellation) {
  IntegerRing ring;
  for (const std::size_t v : region.vertices_of(index)) {
    cancellation.check(8 * work_of_product(RegionAccess::bits(region, v)) + work_of_vertex(scale));
    const Point point = region.point(v);
    ring.vertices.push_back(
        {scaled(point.x, scale, cancellation), scaled(point.y, scale, cancellation)});
  }
  drop_repeated_vertices(ring.vertices);
  const BigInteger area = doubled_area(ring, cancellation);
  if (area != 0) drop_straight_vertices(ring, cancellation);
  if (ring.size() < 2 || (is_hole && area == 0)) broken("an operand has a ring without area");
  if (area != 0 && (area < 0) != is_hole) std::reverse(ring.vertices.begin(), ring.vertices.end());
  ring.extent = extent_of(ring.vertices);
  // No vertex is straight. At both ends of a walk, its edges are parallel.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    cancellation.check(work_of_cross(ring.vertices[i]));
    ring.convex.push_back(cross(edge(ring, ring.previous(i)), edge(ring, i)) >= 0);
  }
  return ring;
}

std::vector<IntegerPart> make_parts(const Region& region, const BigInteger& scale,
                                    Cancellation& cancellation) {
  std::vector<IntegerPart> parts;
  for (const std::size_t polygon : region.polygons()) {
    IntegerPart& part = parts.emplace_back();
    for (const std::size_t ring : region.rings_of(polygon)) {
      part.push_back(make_ring(region, ring, scale, !part.empty(), cancellation));
    }
    if (part.empty()) broken("an operand has a polygon without rings");
  }
  return parts;
}

bool in_first_half(const IntegerPoint& d) { return d.x > 0 || (d.x == 0 && d.y > 0); }

bool direction_less(const IntegerPoint& a, const IntegerPoint& b) {
  const bool a_first = in_first_half(a);
  if (a_first != in_first_half(b)) return a_first;
  return cross(a, b) > 0;
}

/// Calls visit(ring, is_hole) for each ring of both operands.
template <class Operands, class Visit>
void for_each_ring(Operands& operands, Visit visit) {
  for (auto* const parts : {&operands.p, &operands.q}) {
    for (auto& part : *parts) {
      for (auto& ring : part) visit(ring, &ring != &part.front());
    }
  }
}

void rank_directions(IntegerOperands& operands, Cancellation& cancellation) {
  struct DirectedEdge {
    IntegerPoint direction;
    IntegerRing* ring;
    std::uint32_t index;
  };
  std::vector<DirectedEdge> edges;
  for_each_ring(operands, [&](IntegerRing& ring, bool) {
    cancellation.check(4 * ring.size());
    for (std::uint32_t i = 0; i < ring.size(); ++i) edges.push_back({edge(ring, i), &ring, i});
    ring.directions.resize(ring.size());
  });
  std::sort(edges.begin(), edges.end(), [&](const DirectedEdge& a, const DirectedEdge& b) {
    cancellation.check(4 + 2 * work_of_cross(a.direction));
    return direction_less(a.direction, b.direction);
  });
  DirectionRank rank = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    cancellation.check(4 + 2 * work_of_cross(edges[i].direction));
    if (i > 0 && direction_less(edges[i - 1].direction, edges[i].direction)) ++rank;
    edges[i].ring->directions[edges[i].index] = rank;
    edges[i].ring->by_direction.push_back(edges[i].index);
  }
  operands.direction_count = rank + 1;
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

IntegerOperands make_operands(const Region& p, const Region& q, Cancellation& cancellation) {
  IntegerOperands operands;
  operands.scale = least_common_multiple(least_common_denominator(p, cancellation),
                                         {least_common_denominator(q, cancellation)}, cancellation);
  operands.p = make_parts(p, operands.scale, cancellation);
  operands.q = make_parts(q, operands.scale, cancellation);
  rank_directions(operands, cancellation);
  return operands;
}

Region walks_along(std::span<const Polyline> polylines, Cancellation& cancellation) {
  Region walks;
  for (const Polyline& polyline : polylines) {
    walks.begin_polygon();
    walks.begin_ring();
    const auto add = [&](const Point& at) {
      cancellation.check(work_of(at));
      walks.add_vertex(at.x, at.y);
    };
    std::for_each(polyline.begin(), polyline.end(), add);
    std::for_each(polyline.rbegin() + 1, polyline.rend() - 1, add);
  }
  return walks;
}

void check(const IntegerOperands& operands) {
  std::vector<std::pair<DirectionRank, IntegerPoint>> edges;
  for_each_ring(operands, [&](const IntegerRing& ring, bool is_hole) {
    check_ring(ring, !is_hole, operands.direction_count);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.emplace_back(ring.directions[i], edge(ring, i));
    }
  });
  std::sort(edges.begin(), edges.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& [rank, direction] = edges[i - 1];
    const auto& [next_rank, next_direction] = edges[i];
    if (direction_less(direction, next_direction) != (rank < next_rank) ||
        direction_less(next_direction, direction)) {
      broken("the directions of the operands are not in order");
    }
  }
}

}  // namespace minksum::signed_sum

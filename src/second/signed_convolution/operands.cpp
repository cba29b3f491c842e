#include "second/signed_convolution/operands.hpp"

#include <algorithm>
#include <utility>

#include "region/point_arithmetic.hpp"
#include "region/rational_access.hpp"

namespace minksum::signed_sum {
namespace {

/// Returns the units of work of such a product.
std::uint64_t work_of_cross(const Direction& a) {
  return 2 * work_of_product(64 * std::max(a.x.limb_count(), a.y.limb_count()));
}

Direction direction(const Point& from, const Point& to) {
  const Point edge = minus(to, from);
  return {RationalAccess::numerator(edge.x) * RationalAccess::denominator(edge.y),
          RationalAccess::numerator(edge.y) * RationalAccess::denominator(edge.x)};
}

bool in_first_half(const Direction& d) { return d.x > 0 || (d.x == 0 && d.y > 0); }

bool direction_less(const Direction& a, const Direction& b) {
  const bool a_first = in_first_half(a);
  if (a_first != in_first_half(b)) return a_first;
  return cross(a, b) > 0;
}

/// A vertex of a region.
struct Vertex {
  std::size_t index;
  Point at;
};

/// Lists the vertices of a ring without repetitions.
std::vector<Vertex> vertices_of(const Region& region, std::size_t ring,
                                Cancellation& cancellation) {
  std::vector<Vertex> vertices;
  for (const std::size_t v : region.vertices_of(ring)) {
    Point at = region.point(v);
    cancellation.check(work_of(at));
    if (vertices.empty() || vertices.back().at != at) vertices.push_back({v, std::move(at)});
  }
  while (vertices.size() > 1 && vertices.front().at == vertices.back().at) vertices.pop_back();
  if (vertices.size() < 2) broken("an operand has a ring without area");
  return vertices;
}

/// Returns 1 for a counter-clockwise ring, -1 for a clockwise ring, and 0 for a walk. A walk reads
/// the same from both sides. Elsewhere, the turn at the smallest vertex is that of the ring.
int turn_of(std::span<const Vertex> ring, Cancellation& cancellation) {
  const auto same = [](const Vertex& a, const Vertex& b) { return a.at == b.at; };
  if (std::equal(ring.begin() + 1, ring.end(), ring.rbegin(), same)) return 0;
  const auto least = std::min_element(ring.begin(), ring.end(),
                                      cancellation.counting([](const Vertex& a, const Vertex& b) {
                                        return comes_before(a.at, b.at);
                                      }));
  const Vertex& before = least == ring.begin() ? ring.back() : *(least - 1);
  const Vertex& after = least + 1 == ring.end() ? ring.front() : *(least + 1);
  return cross(minus(least->at, before.at), minus(after.at, least->at)).sign();
}

Point extent_of(std::span<const Vertex> ring, Cancellation& cancellation) {
  const auto [left, right] = std::minmax_element(
      ring.begin(), ring.end(),
      cancellation.counting([](const Vertex& a, const Vertex& b) { return a.at.x < b.at.x; }));
  const auto [low, high] = std::minmax_element(
      ring.begin(), ring.end(),
      cancellation.counting([](const Vertex& a, const Vertex& b) { return a.at.y < b.at.y; }));
  return {right->at.x - left->at.x, high->at.y - low->at.y};
}

DirectedRing make_ring(const Region& region, std::size_t index, bool is_hole,
                       Cancellation& cancellation) {
  std::vector<Vertex> vertices = vertices_of(region, index, cancellation);
  const int turn = turn_of(vertices, cancellation);
  if (is_hole && turn == 0) broken("an operand has a hole without area");
  if (turn != 0 && (turn < 0) != is_hole) std::reverse(vertices.begin(), vertices.end());
  std::vector<Direction> edges;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    cancellation.check(work_of(vertices[i].at));
    edges.push_back(direction(vertices[i].at, vertices[i + 1 == vertices.size() ? 0 : i + 1].at));
  }
  DirectedRing ring;
  ring.region = &region;
  ring.extent = extent_of(vertices, cancellation);
  // In a simple ring, a straight vertex goes straight on. Leaving it out keeps the directions of
  // its neighbours' edges. No vertex of a walk goes on, and at both ends its edges are parallel.
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    cancellation.check(4 + work_of_cross(edges[i]));
    const int here = cross(edges[(i == 0 ? edges.size() : i) - 1], edges[i]).sign();
    if (turn != 0 && here == 0) continue;
    ring.vertices.push_back(vertices[i].index);
    ring.edges.push_back(edges[i]);
    ring.convex.push_back(here >= 0);
  }
  return ring;
}

std::vector<Part> make_parts(const Region& region, Cancellation& cancellation) {
  std::vector<Part> parts;
  for (const std::size_t polygon : region.polygons()) {
    Part& part = parts.emplace_back();
    for (const std::size_t ring : region.rings_of(polygon)) {
      part.push_back(make_ring(region, ring, !part.empty(), cancellation));
    }
    if (part.empty()) parts.pop_back();
  }
  return parts;
}

void rank_directions(DirectedOperands& operands, Cancellation& cancellation) {
  struct Edge {
    DirectedRing* ring;
    std::uint32_t index;
    [[nodiscard]] const Direction& direction() const { return ring->edges[index]; }
  };
  std::vector<Edge> edges;
  for (auto* const parts : {&operands.p, &operands.q}) {
    for (Part& part : *parts) {
      for (DirectedRing& ring : part) {
        cancellation.check(ring.size());
        for (std::uint32_t i = 0; i < ring.size(); ++i) edges.push_back({&ring, i});
        ring.ranks.resize(ring.size());
      }
    }
  }
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    cancellation.check(2 + work_of_cross(a.direction()));
    return direction_less(a.direction(), b.direction());
  });
  DirectionRank rank = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [ring, index] = edges[i];
    cancellation.check(4 + work_of_cross(edges[i].direction()));
    if (i > 0 && direction_less(edges[i - 1].direction(), edges[i].direction())) ++rank;
    ring->ranks[index] = rank;
    ring->by_direction.push_back(index);
  }
  operands.direction_count = rank + 1;
}

}  // namespace

DirectedOperands make_operands(const Region& p, const Region& q, Cancellation& cancellation) {
  DirectedOperands operands;
  operands.p = make_parts(p, cancellation);
  operands.q = make_parts(q, cancellation);
  rank_directions(operands, cancellation);
  return operands;
}

}  // namespace minksum::signed_sum

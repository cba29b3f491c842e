// Finds what is wrong with the operands of the signed method.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "region/point_arithmetic.hpp"
#include "second/signed_convolution/operands.hpp"

namespace minksum::signed_sum {

/// An edge with its rank, and whether it comes in the second half of the circle.
struct RankedEdge {
  DirectionRank rank;
  bool second_half;
  Point along;
};

/// Returns what is wrong with a ring, or an empty text. Rings must be oriented or walks, without
/// straight or repeated vertices.
inline std::string fault_of(const DirectedRing& ring, bool is_hole,
                            std::vector<RankedEdge>& edges) {
  Rational area;
  int ends = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point at = ring.point(i);
    const Point in = minus(at, ring.point(ring.previous(i)));
    const Point out = minus(ring.point(ring.next(i)), at);
    const int turn = cross(in, out).sign();
    area = area + cross(at, out);
    if (turn == 0 && dot(in, out).sign() >= 0) return "a straight vertex";
    ends += turn == 0 ? 1 : 0;
    if ((turn >= 0) != ring.convex[i]) return "a misjudged vertex";
    const int up = out.y.sign();
    edges.push_back({ring.ranks[i], up < 0 || (up == 0 && out.x.sign() < 0), out});
  }
  if (area.sign() != 0 && (area.sign() < 0) != is_hole) return "a wrong orientation";
  return ends == (area.sign() == 0 ? 2 : 0) ? "" : "neither a polygon nor a polyline";
}
/// Does the same for operands. Ranks must be in cyclic order of the directions.
inline std::string fault_of(const DirectedOperands& operands) {
  std::vector<RankedEdge> edges;
  for (const auto* const parts : {&operands.p, &operands.q}) {
    for (const Part& part : *parts) {
      for (const DirectedRing& ring : part) {
        const std::string fault = fault_of(ring, &ring != &part.front(), edges);
        if (!fault.empty()) return fault;
      }
    }
  }
  std::sort(edges.begin(), edges.end(), [](const RankedEdge& a, const RankedEdge& b) {
    if (a.second_half != b.second_half) return b.second_half;
    return cross(a.along, b.along).sign() > 0;
  });
  DirectionRank rank = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool same = i > 0 && edges[i - 1].second_half == edges[i].second_half &&
                      cross(edges[i - 1].along, edges[i].along).sign() == 0;
    if (i > 0 && !same) ++rank;
    const DirectionRank count = operands.direction_count;
    if (edges[i].rank != (edges[0].rank + rank) % count) return "a wrong rank";
  }
  return operands.direction_count == rank + 1 ? "" : "a wrong number of directions";
}

}  // namespace minksum::signed_sum

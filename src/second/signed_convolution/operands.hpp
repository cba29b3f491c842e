// Step 1 of the signed method: turns both operands into oriented rings, and ranks the directions of
// all edges once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/big_integer.hpp"
#include "exact/formulas.hpp"
#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"

namespace minksum::signed_sum {

/// Throws because an invariant of this method does not hold, which is never the input's fault.
[[noreturn]] inline void broken(const char* message) {
  throw Error(ErrorCode::kInternal, message, {}, "signed convolution");
}

/// The place of an edge's direction among all distinct directions of both operands, in
/// counter-clockwise order. Equal directions have equal ranks. The order is cyclic.
using DirectionRank = std::uint32_t;

/// A vector of integers in an edge's direction.
using Direction = Vec<BigInteger>;

/// A simple ring without repeated or straight vertices, with material on its left, or a walk along
/// a polyline and back. Edge i runs from vertex i to vertex i + 1. In the limit, a walk is the
/// boundary of the polyline made a little wider. The walk turns left by half a circle at both ends.
struct DirectedRing {
  const Region* region = nullptr;
  std::vector<std::size_t> vertices;  ///< of the region
  Point extent;                       ///< of its box
  std::vector<Direction> edges;
  std::vector<DirectionRank> ranks;         ///< by edge
  std::vector<bool> convex;                 ///< by vertex: a left turn, up to half a circle
  std::vector<std::uint32_t> by_direction;  ///< the edges, sorted by rank

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i == 0 ? size() : i) - 1; }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] Point point(std::size_t i) const { return region->point(vertices[i]); }
};

/// The rings of a polygon: the outer one, which is counter-clockwise or a walk, and clockwise
/// holes.
using Part = std::vector<DirectedRing>;

struct DirectedOperands {
  std::vector<Part> p;
  std::vector<Part> q;
  DirectionRank direction_count = 0;
};

/// Reads valid regions, in which polygons may also be walks. The regions must live as long as the
/// result.
[[nodiscard]] DirectedOperands make_operands(const Region& p, const Region& q,
                                             Cancellation& cancellation);

}  // namespace minksum::signed_sum

// Stage 7: turns accepted loops into a region.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "minksum/region.hpp"
#include "sum/filters/filters.hpp"

namespace minksum {

/// A vertex of the boundary: the node, and the piece that starts the edge there.
struct BoundaryVertex {
  NodeId node;
  PieceId piece;
};

struct BoundaryRing {
  std::uint32_t begin = 0;  ///< its vertices are [begin, end), lexicographically smallest first
  std::uint32_t end = 0;
  bool positive = false;
  std::uint32_t walk = 0;   ///< rings that were one walk along the interior share this
};

/// Simple rings in canonical form. Each has the sum on its left, and no vertex in the middle of a
/// straight edge. Rings touch at most at nodes.
struct Boundary {
  std::vector<BoundaryVertex> vertices;
  std::vector<BoundaryRing> rings;
  std::vector<std::uint32_t> ring_order;     ///< polygon after polygon, outer ring first
  std::vector<std::uint32_t> polygon_begin;  ///< by polygon: index in ring_order; one entry more
};

/// A walk without an outer ring: its rings are [first, last). The point just left of its leftmost
/// node is inside the sum.
struct LoneWalk {
  std::uint32_t first;
  std::uint32_t last;
  NodeId leftmost;
};

/// Walks without an outer ring, by rows of the plane. An edge of an outer ring looks at its rows
/// only.
struct WalkRows {
  double bottom = 0;
  double inverse = 0;                ///< rows per unit
  double error = 0;                  ///< bound on the error of any leftmost node's place
  std::size_t count = 0;             ///< number of rows beside the lowest and the highest
  std::vector<std::uint32_t> begin;  ///< by row: where its walks begin; and one entry more
  std::vector<std::uint32_t> walks;

  [[nodiscard]] std::size_t row_of(double y) const {
    const auto last = static_cast<double>(count + 1);
    return static_cast<std::size_t>(std::clamp((y - bottom) * inverse + 1, 0.0, last));
  }
};

struct OutputScratch {
  std::vector<std::uint8_t> accepted;
  std::vector<std::uint8_t> passed;        ///< by node
  Incidence incidence;
  std::vector<std::uint32_t> stack_place;  ///< by node
  std::vector<PieceId> stack;
  std::vector<std::uint32_t> outer_of;     ///< by ring
  std::vector<LoneWalk> lone;
  WalkRows rows;
  /// Lone walks, and the outer rings that their rays pass.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> passes;
  std::vector<std::uint32_t> around;       ///< outer rings around a point
  Vec<ExactCoordinate> coordinates;
};

/// Links the pieces of accepted loops into rings and polygons. O(c log c). If there are several
/// outer rings, their edges also look at the holes in their rows of the plane.
void extract_rings(const Operands& operands, const Arrangement& arrangement, const Loops& loops,
                   const FilteredLoops& filtered, Predicates& predicates, OutputScratch& scratch,
                   Boundary& boundary);

/// Assigns holes to outer rings and puts everything in canonical order. Called by extract_rings.
void order_rings(const Arrangement& arrangement, Predicates& predicates, OutputScratch& scratch,
                 Boundary& boundary);

/// Writes the boundary as a region, with exact coordinates and origins.
void write_region(const Operands& operands, const Arrangement& arrangement,
                  const Boundary& boundary, Cancellation& cancellation, OutputScratch& scratch,
                  Region& region);

/// Returns what is wrong with the boundary, or nothing. Its rings must be simple as far as their
/// nodes tell, oriented, and in canonical order.
[[nodiscard]] std::optional<std::string> check(const Boundary& boundary,
                                               const Arrangement& arrangement,
                                               const Operands& operands);

}  // namespace minksum

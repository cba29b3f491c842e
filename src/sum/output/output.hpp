// Stage 7: turns accepted loops into a region.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

/// The edges of outer rings, by rows of the plane. Only one row's edges may pass a given height.
struct RowIndex {
  double bottom = 0;
  double inverse = 0;                ///< rows per unit
  double error = 0;                  ///< bound on the error of any node's place
  std::size_t count = 0;             ///< number of rows
  /// By row: where its edges begin in `edges`; and one entry more. Empty until the index is built.
  std::vector<std::uint32_t> begin;
  struct Edge {
    std::uint32_t ring;
    std::uint32_t vertex;
  };
  std::vector<Edge> edges;
};

struct OutputScratch {
  std::vector<std::uint8_t> accepted;
  std::vector<std::uint8_t> passed;        ///< by node
  Incidence incidence;
  std::vector<std::uint32_t> stack_place;  ///< by node
  std::vector<PieceId> stack;
  std::vector<std::uint32_t> outer_of;     ///< by ring
  RowIndex rows;
  std::vector<std::uint8_t> odd;           ///< by ring: parity of the times that a ray passed it
  std::vector<std::uint32_t> around;       ///< outer rings around a point
  Vec<ExactCoordinate> coordinates;
};

/// Links the pieces of accepted loops into rings and polygons. O(c log c), and a search along one
/// row of edges for each hole if there are several outer rings.
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

// Stage 1: both operands on one exact grid, clean, oriented, validated, their directions sorted.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "minksum/minkowski_sum.hpp"
#include "minksum/validity.hpp"
#include "predicate/predicates.hpp"

namespace minksum {

/// A ring: the sites [begin, end), counter-clockwise if outer, clockwise if a hole. It has three or
/// more vertices; none is repeated or lies in the middle of a straight edge.
struct OperandRing {
  SiteId begin = 0;
  SiteId end = 0;
  std::uint32_t polygon = 0;  ///< index in its region
  std::uint32_t ring = 0;     ///< index in its polygon, 0 = outer
  [[nodiscard]] bool is_hole() const { return ring != 0; }
};

/// The rank of an edge's direction among all directions of both operands, counter-clockwise from
/// the positive x axis; parallel edges of equal sense share a rank.
using DirectionRank = std::uint32_t;

/// An edge with a rounded, monotone function of its direction.
struct KeyedEdge {
  double key;
  SiteId edge;
};

/// A ring's box, rounded.
struct RingBox {
  double x0, x1, y0, y1;
};

/// Memory that the stage needs in passing, kept from call to call.
struct OperandsScratch {
  GridCoordinates grid;
  std::vector<SiteId> order;
  std::vector<SiteId> distinct;
  std::vector<SiteId> kept;
  std::vector<OperandRing> rings;
  std::vector<std::uint32_t> edge_source;
  std::vector<std::uint32_t> picked_indices;
  std::vector<double> picked_coordinates;
  std::vector<KeyedEdge> keyed;
  std::vector<SiteId> of_rank;
  std::array<std::vector<Vec<double>>, 2> sizes;
  std::vector<std::size_t> ring_of;
  std::vector<std::size_t> cell_begin;
  std::vector<SiteId> in_cells;
  std::vector<RingBox> boxes;
};

/// What the rest of the pipeline works on. Sites of the first operand are [0, split).
///
/// The approximate coordinates start at (0, 0) for each operand's box. Holes that nothing of the
/// other operand fits into have been filled: their rings are gone (theory: Baram et al. 2015).
struct Operands {
  ApproximateSites sites;
  SiteId split = 0;
  std::vector<SiteId> previous;
  std::vector<OperandRing> rings;  ///< the first operand's, then the second's
  std::size_t first_rings = 0;     ///< how many are the first operand's
  std::vector<std::uint8_t> on_hole;
  std::vector<std::uint8_t> convex;  ///< strictly left turn

  std::vector<DirectionRank> rank;     ///< by edge
  std::vector<SiteId> by_direction;    ///< all edges, sorted by rank
  /// By rank: where the direction and its reverse stand, counter-clockwise, on a circle of all
  /// directions and all reverses; a reverse that is itself a direction shares its place.
  std::vector<std::uint32_t> place;
  std::vector<std::uint32_t> reverse_place;
  std::uint32_t place_count = 0;
  DirectionRank rank_count = 0;

  std::vector<std::uint32_t> vertex_source;  ///< by site: vertex index in its region
  std::vector<std::uint32_t> edge_source;    ///< by site: edge index in its region

  std::array<Vec<double>, 2> extent{};  ///< width and height of each operand's box
  RoundingBounds bounds;
  std::uint64_t bits = 0;               ///< of the coordinates
  bool connected = false;               ///< each operand is one polygon
  Vec<double> trace_origin{};           ///< trace coordinate = approximate · unit + origin
  double trace_unit = 1;
  std::unique_ptr<ExactKernel> kernel;
  OperandsScratch scratch;
  GridCoordinates grid;                 ///< scratch, kept for its memory

  [[nodiscard]] SiteId size() const { return static_cast<SiteId>(sites.x.size()); }
  [[nodiscard]] int operand_of(SiteId site) const { return site < split ? 0 : 1; }
};

/// Fills `operands` from two regions. Throws Error(kBadInput) naming the first fault.
/// O(n log n) for n vertices in all, plus close pairs of edges for the validation.
void prepare_operands(const Region& p, const Region& q, const Options& options,
                      Operands& operands);

/// Whether `operands` keeps its promises; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const Operands& operands);

// -- Steps of the stage, for their tests and for `validate` ------------------------------------

/// Exact and approximate coordinates of all vertices as given: sites are p's vertices, then q's.
void load_sites(const Region& p, const Region& q, const Options& options, Operands& operands);
/// Drops repeated and straight vertices, orients the rings. Faults go to `faults`; their rings are
/// left out.
void clean_rings(const Region& p, const Region& q, Operands& operands,
                 std::array<std::vector<Fault>, 2>& faults);
/// Faults between edges and rings of one operand (0 or 1).
void find_faults(Operands& operands, int operand, std::size_t max_faults,
                 std::vector<Fault>& faults);
/// Drops the rings of holes into which no polygon of the other operand fits.
void fill_holes(Operands& operands);
/// Sorts directions; sets rank, by_direction, the places and convex.
void rank_directions(Operands& operands);
/// Keeps the sites in `scratch.order` only, in this order, and renumbers all arrays;
/// `scratch.rings`, in new ids, become the rings.
void select_sites(std::size_t first_rings, Operands& operands);

}  // namespace minksum

// Stage 1: both operands on one exact grid, clean, oriented, validated, their directions ranked.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sum/operands/prepare_operand.hpp"

namespace minksum {

/// The rank of an edge's direction among all directions of both operands, counter-clockwise from
/// the positive x axis; parallel edges of equal sense share a rank.
using DirectionRank = std::uint32_t;

/// Memory that combining needs in passing, kept from call to call.
struct OperandsScratch {
  std::array<std::vector<SiteId>, 2> kept;  ///< sites of an operand that stay
  std::vector<SiteId> renumbered;
  std::vector<KeyedEdge> of_rank;  ///< an edge of each rank
  std::array<std::vector<KeyedEdge>, 2> sorted;  ///< each operand's edges, by their new numbers
  std::array<std::vector<Vec<double>>, 2> sizes;
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
  std::vector<std::uint8_t> convex;  ///< strictly left turn, or half a circle

  std::vector<DirectionRank> rank;     ///< by edge
  std::vector<SiteId> by_direction;    ///< all edges, sorted by rank
  /// By rank: where the direction and its reverse stand, counter-clockwise from the positive x
  /// axis, on a circle of all directions and all reverses; a reverse that is itself a direction
  /// shares its place.
  std::vector<std::uint32_t> place;
  std::vector<std::uint32_t> reverse_place;
  std::uint32_t place_count = 0;
  DirectionRank rank_count = 0;

  std::vector<std::uint32_t> vertex_source;  ///< by site: vertex index in its region
  std::vector<std::uint32_t> edge_source;    ///< by site: edge index in its region

  std::array<Vec<double>, 2> extent{};  ///< width and height of each operand's box
  RoundingBounds bounds;
  std::uint64_t bits = 0;               ///< of the coordinates
  std::array<bool, 2> thin{};           ///< whether an operand is polylines
  bool connected = false;               ///< each operand is one polygon, or polyline; not both thin
  bool holes_filled = false;            ///< rings are gone; other polygons may lie there
  bool both_convex = false;             ///< each operand is one convex ring
  Vec<double> trace_origin{};           ///< trace coordinate = approximate · unit + origin
  double trace_unit = 1;
  std::unique_ptr<ExactKernel> kernel;
  OperandsScratch scratch;

  [[nodiscard]] SiteId size() const { return static_cast<SiteId>(sites.x.size()); }
  [[nodiscard]] int operand_of(SiteId site) const { return site < split ? 0 : 1; }
  [[nodiscard]] bool both_thin() const { return thin[0] && thin[1]; }
  /// Whether the sum has no area: all edges are walked there and back along one direction.
  [[nodiscard]] bool all_parallel() const { return both_thin() && rank_count == 2; }
  /// Whether the ring turns by half a circle at a site: the end of a walk.
  [[nodiscard]] bool turns_back(SiteId site) const {
    return place[rank[site]] == reverse_place[rank[previous[site]]];
  }
};

/// What becomes of holes that nothing of the other operand fits into.
enum class NarrowHoles : std::uint8_t { kFill, kKeep };

/// Fills `operands` from two operands without faults. O(n + m) for n and m sites, if neither's
/// coordinates are wide.
void combine_operands(const PreparedOperand& p, const PreparedOperand& q, const Options& options,
                      NarrowHoles narrow, Cancellation& cancellation, Operands& operands);

/// Whether `operands` keeps its promises; what is wrong, if not.
[[nodiscard]] std::optional<std::string> check(const Operands& operands);

/// The sums of parallel edges of two thin operands, made from these walks: one segment a pair.
/// O(n + m + pairs). Throws Error(kLimitExceeded) for more of them than segments are allowed.
void list_parallel_sums(const Operands& operands, std::span<const Region, 2> walks,
                        const Limits& limits, Cancellation& cancellation,
                        std::vector<Polyline>& sums);

// -- Steps, in their order ---------------------------------------------------------------------
/// Lists the sites that stay: all, or not those of holes into which no polygon of the other operand
/// fits.
///
/// If tight places are wanted, what fits without any play fits, and so does part of a polygon whose
/// rings touch and cut its inside in parts. So holes are filled only if strictly narrower than
/// polygons without holes; and only in operands of one polygon, so that polygons never overlap.
void fill_holes(const PreparedOperand& p, const PreparedOperand& q, NarrowHoles narrow,
                bool tight_wanted, Cancellation& cancellation, Operands& operands);
/// Both operands' exact coordinates on their common grid.
void join_sites(const PreparedOperand& p, const PreparedOperand& q, const Options& options,
                Cancellation& cancellation, Operands& operands);
/// Merges directions; sets rank, by_direction and the places.
void rank_directions(const PreparedOperand& p, const PreparedOperand& q, Cancellation& cancellation,
                     Operands& operands);

}  // namespace minksum

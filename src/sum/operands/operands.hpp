// Stage 1: brings both operands to one exact grid: clean, oriented, validated, directions ranked.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "minksum/testing.hpp"
#include "sum/operands/prepare_operand.hpp"

namespace minksum {

/// The rank of an edge's direction among all directions of both operands. Ranks count
/// counter-clockwise from the positive x axis; parallel edges of equal sense share a rank.
using DirectionRank = std::uint32_t;

/// Scratch memory for combining, kept from call to call.
struct OperandsScratch {
  std::array<std::vector<SiteId>, 2> kept;  ///< sites of an operand that stay
  std::vector<SiteId> renumbered;
  std::vector<KeyedEdge> of_rank;  ///< by rank: one edge of that direction
  std::array<std::vector<KeyedEdge>, 2> sorted;  ///< each operand's edges, by their new numbers
  std::array<std::vector<Vec<double>>, 2> sizes;
};

/// Both operands, as all later stages read them. Sites of the first operand are [0, split).
///
/// In approximate coordinates, the lower left corner of each operand's box is (0, 0). Holes into
/// which nothing of the other operand fits are filled: their rings are gone (Baram et al. 2015).
struct Operands {
  ApproximateSites sites;
  SiteId split = 0;
  std::vector<SiteId> previous;
  std::vector<OperandRing> rings;  ///< the first operand's, then the second's
  std::size_t first_rings = 0;     ///< how many of `rings` are the first operand's
  std::vector<std::uint8_t> on_hole;
  std::vector<std::uint8_t> convex;  ///< whether the ring turns left, or back by half a circle

  std::vector<DirectionRank> rank;     ///< by edge
  std::vector<SiteId> by_direction;    ///< all edges, sorted by rank
  /// By rank: the positions of the direction and of its reverse on the circle of all directions and
  /// reverses, counter-clockwise from the positive x axis. A reverse that is itself a direction has
  /// that direction's position.
  std::vector<std::uint32_t> place;
  std::vector<std::uint32_t> reverse_place;
  std::uint32_t place_count = 0;
  DirectionRank rank_count = 0;

  std::vector<std::uint32_t> vertex_source;  ///< by site: vertex index in its region
  std::vector<std::uint32_t> edge_source;    ///< by site: edge index in its region

  std::array<Vec<double>, 2> extent{};  ///< width and height of each operand's box
  RoundingBounds bounds;
  std::uint64_t bits = 0;               ///< length of the coordinates
  std::array<bool, 2> thin{};           ///< whether an operand consists of polylines
  bool connected = false;               ///< each operand is one polygon, or polyline; not both thin
  bool holes_filled = false;            ///< rings are gone; other polygons may lie inside them
  bool both_convex = false;             ///< each operand is one convex ring
  bool equal = false;                   ///< the operands are known to be equal, up to a translation
  Vec<double> trace_origin{};           ///< trace coordinate = approximate · unit + origin
  double trace_unit = 1;
  std::unique_ptr<ExactKernel> kernel;
  OperandsScratch scratch;

  [[nodiscard]] SiteId size() const { return static_cast<SiteId>(sites.x.size()); }
  /// Returns width and height of the sum's box, which starts at (0, 0).
  [[nodiscard]] Vec<double> sum_extent() const {
    return {extent[0].x + extent[1].x, extent[0].y + extent[1].y};
  }
  [[nodiscard]] int operand_of(SiteId site) const { return site < split ? 0 : 1; }
  [[nodiscard]] bool both_thin() const { return thin[0] && thin[1]; }
  /// Whether the sum has no area, because all edges of two thin operands are parallel.
  [[nodiscard]] bool all_parallel() const { return both_thin() && rank_count == 2; }
  /// Returns the steps counter-clockwise from one place on the circle of directions to another.
  [[nodiscard]] std::uint32_t turn(std::uint32_t from, std::uint32_t to) const {
    return to >= from ? to - from : to + place_count - from;
  }
  /// Whether the ring turns back by half a circle at a site. Only the ends of a walk do.
  [[nodiscard]] bool turns_back(SiteId site) const {
    return place[rank[site]] == reverse_place[rank[previous[site]]];
  }
};

/// Whether to fill holes into which nothing of the other operand fits.
enum class NarrowHoles : std::uint8_t { kFill, kKeep };

/// Fills `operands` from two operands without faults. O(n + m) for n and m sites, if neither
/// operand's coordinates are wide.
void combine_operands(const PreparedOperand& p, const PreparedOperand& q, const SumSettings& options,
                      NarrowHoles narrow, Cancellation& cancellation, Operands& operands);

/// Returns what is wrong with `operands`, or nothing.
[[nodiscard]] std::optional<std::string> check(const Operands& operands);

/// Returns paths that together are the same set as polylines of a resolved geometry. These end
/// wherever they meet. Two that go straight on become one path without a vertex there, and other
/// ends at one point are joined two by two. So paths may cross one another and themselves. For n
/// ends of polylines it takes O(n log n), and the time to copy the vertices.
[[nodiscard]] std::vector<Polyline> join_paths(const std::vector<Polyline>& polylines,
                                               Cancellation& cancellation);

/// Lists the sums of parallel edges of two thin operands, one segment for each pair, unless it
/// surely lies within the area of the sum. The operands were made from `walks`. O(n + m + pairs).
/// Throws Error(kLimitExceeded) for more segments than `limits.max_segments`.
void list_parallel_sums(const Operands& operands, std::span<const Region, 2> walks,
                        const Limits& limits, Cancellation& cancellation,
                        std::vector<Polyline>& sums);

// -- Steps, in their order ---------------------------------------------------------------------
/// Lists the sites that stay: all but those of filled holes. With NarrowHoles::kFill, a hole is
/// filled if no polygon of the other operand fits into it.
///
/// If tight places are wanted, a polygon fits even without any play. So does part of a polygon
/// whose rings touch and cut its inside in parts. Then a hole is filled only if it is strictly
/// narrower than the other operand's polygons, and these have no holes. It is filled only in an
/// operand of one polygon, so that polygons never overlap.
void fill_holes(const PreparedOperand& p, const PreparedOperand& q, NarrowHoles narrow,
                bool tight_wanted, Cancellation& cancellation, Operands& operands);
/// Brings both operands' exact coordinates to their common grid.
void join_sites(const PreparedOperand& p, const PreparedOperand& q, const SumSettings& options,
                Cancellation& cancellation, Operands& operands);
/// Merges both operands' directions, and sets everything that concerns ranks and places.
void rank_directions(const PreparedOperand& p, const PreparedOperand& q, Cancellation& cancellation,
                     Operands& operands);

}  // namespace minksum

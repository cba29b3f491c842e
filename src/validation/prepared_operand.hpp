// Defines one operand by itself: on an integer grid, clean, oriented and validated.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "exact/predicates.hpp"
#include "minksum/testing.hpp"
#include "minksum/validity.hpp"
#include "spatial/box.hpp"
#include "spatial/box_pairs.hpp"
#include "validation/misplaced_rings.hpp"
#include "validation/ring_sweep.hpp"

namespace minksum {

/// A ring: the sites [begin, end), counter-clockwise if outer, clockwise if a hole. A ring has
/// three or more vertices. No vertex is repeated or lies in the middle of a straight edge. In a
/// thin operand, a ring is a walk along a polyline and back, of two sites or more.
struct OperandRing {
  SiteId begin = 0;
  SiteId end = 0;
  std::uint32_t polygon = 0;  ///< index in its region
  std::uint32_t ring = 0;     ///< index in its polygon, 0 = outer
  [[nodiscard]] bool is_hole() const { return ring != 0; }
  friend bool operator==(const OperandRing&, const OperandRing&) = default;
};
[[nodiscard]] inline bool has_holes(std::span<const OperandRing> rings) {
  return std::ranges::any_of(rings, &OperandRing::is_hole);
}
/// Returns the index of the ring that holds a site.
[[nodiscard]] inline std::size_t ring_of(std::span<const OperandRing> rings, SiteId site) {
  const auto after = std::ranges::upper_bound(rings, site, {}, &OperandRing::begin);
  return static_cast<std::size_t>(after - rings.begin()) - 1;
}

/// Returns the box around a ring.
[[nodiscard]] inline BoxOf<double> box_of(const ApproximateSites& sites, const OperandRing& ring) {
  const auto [x0, x1] =
      std::minmax_element(sites.x.begin() + ring.begin, sites.x.begin() + ring.end);
  const auto [y0, y1] =
      std::minmax_element(sites.y.begin() + ring.begin, sites.y.begin() + ring.end);
  return {*x0, *y0, *x1, *y1};
}

/// An edge with its key: a number from 0 to 4 that grows with the angle of its direction. Rounding
/// makes the key off by less than kKeyError.
struct KeyedEdge {
  double key;
  SiteId edge;
};
inline constexpr double kKeyError = 0x1p-48;

/// A vertex of one ring that lies on another: on the edge `other`, or on the vertex `other`.
struct RingTouch {
  SiteId vertex;
  SiteId other;
  bool at_vertex;
};

/// Memory that preparing needs for a while, kept from call to call.
struct OperandScratch {
  std::vector<SiteId> all;  ///< 0, 1, 2, ...
  std::vector<SiteId> order;
  std::vector<SiteId> distinct;
  GridCoordinates picked_grid;
  RationalCoordinates picked_rationals;
  std::vector<KeyedEdge> keyed;
  std::vector<std::uint32_t> counts;
  std::vector<std::uint32_t> cell_begin;
  std::vector<SiteId> in_cells;
  BoxPairScratch pairs;
  RingSweep sweep;
  RingNesting nesting;
  /// Where rings of one polygon touch, if no edges meet wrongly (see `sweep_rings`).
  std::vector<RingTouch> touches;
};

/// All that can be known of an operand before the other one is known.
///
/// `sites` and `bounds` are in units of the operand's own grid, with the operand's box at (0, 0).
struct PreparedOperand {
  const Region* region = nullptr;
  bool thin = false;               ///< walks along polylines instead of polygons
  bool rational = false;           ///< whether `rationals`, not `grid`, holds the coordinates
  GridCoordinates grid;
  RationalCoordinates rationals;

  ApproximateSites sites;
  std::vector<SiteId> previous;
  std::vector<OperandRing> rings;
  std::vector<std::uint8_t> convex;          ///< whether the site is a strict left turn, or half a
                                             ///< circle
  std::vector<std::uint32_t> vertex_source;  ///< by site: vertex index in the region
  std::vector<std::uint32_t> edge_source;    ///< by site: edge index in the region
  /// Edges counter-clockwise by direction from the positive x axis, and parallel edges by id.
  std::vector<KeyedEdge> by_direction;
  bool keys_tell = false;  ///< whether keys farther apart than 2 · kKeyError order directions

  GridUnit unit;  ///< one step of `sites`
  RoundingBounds bounds;
  std::unique_ptr<ExactKernel> kernel;

  [[nodiscard]] SiteId size() const { return static_cast<SiteId>(sites.x.size()); }
};

/// Fills all of `operand` but its directions from `region`, which must live as long. Lists at most
/// `max_faults` faults. Only `arithmetic` and `filter` of `options` are used. Takes the time
/// of `validate`.
void load_and_validate(const Region& region, const SumSettings& options, std::size_t max_faults,
                       Cancellation& cancellation, OperandScratch& scratch,
                       PreparedOperand& operand, std::vector<Fault>& faults);

// -- Steps, in their order ---------------------------------------------------------------------
/// Loads the exact coordinates of all vertices as given.
void load_sites(const Region& region, const SumSettings& options, Cancellation& cancellation,
                PreparedOperand& operand);
/// Drops repeated and straight vertices, orients the rings, and marks convex vertices. Leaves out
/// rings that have a fault.
void clean_rings(const SumSettings& options, Cancellation& cancellation, OperandScratch& scratch,
                 PreparedOperand& operand, std::vector<Fault>& faults);
/// Finds faults between edges and rings. The faults' vertices are indices in the region.
void find_faults(std::size_t max_faults, Cancellation& cancellation, OperandScratch& scratch,
                 PreparedOperand& operand, std::vector<Fault>& faults);
/// Makes a kernel, bounds and approximate places for the present coordinates of so many sites.
void approximate_sites(std::size_t count, const SumSettings& options, Cancellation& cancellation,
                       OperandScratch& scratch, PreparedOperand& operand);
/// Sets which site follows which around the rings, and the edges between them.
void connect_rings(std::span<const OperandRing> rings, ExactKernel& kernel,
                   Cancellation& cancellation, ApproximateSites& sites,
                   std::vector<SiteId>& previous);
inline void connect_rings(Cancellation& cancellation, PreparedOperand& operand) {
  connect_rings(operand.rings, *operand.kernel, cancellation, operand.sites, operand.previous);
}
/// Returns the narrowest rung for coordinates of so many bits, unless a wider one is asked for.
[[nodiscard]] Arithmetic rung_for(int bits, Arithmetic asked);
/// Coordinates of more bits than this are not given to fixed-width arithmetic.
inline constexpr int kMaxGridBits = WideRung::kCoordinateBits - 1;

}  // namespace minksum

// Declares a sweep over an operand's rings: which edges may be faulty, and which ring is in which.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/sum_geometry.hpp"
#include "spatial/segment_sweep.hpp"

namespace minksum {

struct OperandScratch;
struct PreparedOperand;

/// What a sweep finds, and its memory.
struct RingSweep {
  static constexpr std::uint32_t kNoRing = 0xFFFFFFFFU;

  /// By edge: whether it is suspect. Where rings meet wrongly, at least one of both edges is.
  std::vector<std::uint8_t> suspect;
  bool any_suspect = false;
  /// By ring: the smallest ring around it, or kNoRing. Holds only if no edge is suspect.
  std::vector<std::uint32_t> parent;

  /// A direction in which a vertex has an edge.
  struct Spoke {
    SiteId far;  ///< the other end of the edge
    SiteId edge;
    SiteId vertex;
  };

  /// A site with its rounded place, by which most pairs are in order.
  struct Key {
    double x;
    SiteId site;
  };

  // -- Memory ------------------------------------------------------------------------------------
  std::vector<Key> keys;
  std::vector<SiteId> order;           ///< sites from left to right, and from bottom to top
  std::vector<std::uint32_t> place;    ///< by site: where its point stands in `order`
  std::vector<std::uint32_t> ring_of;  ///< by site
  SegmentSweepScratch segments;
  std::vector<Spoke> right;
  std::vector<Spoke> left;
  std::vector<SiteId> open;
  std::vector<std::uint8_t> is_open;  ///< by site
};

/// Sweeps a vertical line from left to right over the edges of all rings, and fills
/// `scratch.sweep`. Lists in `scratch.touches` where rings of one polygon touch. At such a point,
/// each vertex but the first is listed with the one before, and each with an edge through the
/// point.
///
/// Edges that meet another one wrongly are suspect, and are left out from there on (see
/// SegmentSweep). So time and memory do not depend on how often edges meet: O(n log n) decisions
/// for n edges.
void sweep_rings(const PreparedOperand& operand, Cancellation& cancellation,
                 OperandScratch& scratch);

}  // namespace minksum

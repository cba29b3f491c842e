// Finds the segments that may touch uncovered cells. If there are very many segments, pairs of runs
// are dropped first, and only what is left of them is tested one by one.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spatial/box.hpp"
#include "sum/convolution/convolution.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

/// A box in units of the cover's cells.
using CellBounds = BoxOf<float>;

/// A site and the box of its edge, rounded, in units of cells.
struct CellSite {
  float x, y;
  CellBounds box;
};

/// A run of an operand's sites: of its edges, or of its convex vertices.
struct SiteRun {
  CellBounds box;
  RankRange directions;  ///< contains the edges' directions, or those that the vertices meet
};

/// All runs of an operand's edges or vertices. Leaves have a few sites each; the runs of each
/// further level unite two runs of the level before.
struct RunTree {
  static constexpr SiteId kLeaf = 8;
  SiteId begin = 0;  ///< the operand's sites are [begin, end)
  SiteId end = 0;
  /// The runs level by level, the leaves first. All levels but the root's have an even number.
  std::vector<SiteRun> runs;
  std::vector<std::uint32_t> level_begin;
};

/// A run of edges and a run of vertices.
struct RunPair {
  std::array<std::uint32_t, 2> run;
  std::array<std::uint32_t, 2> level;
};

/// Memory of one thread that searches.
struct alignas(64) RunScratch {  // threads fill neighbours: each needs cache lines of its own
  std::vector<RunPair> pairs;
  std::vector<Segment> found;  ///< in any order
};

/// Memory for the search.
struct VisibleScratch {
  static constexpr std::size_t kLevels = 3;
  std::vector<CellSite> sites;
  std::array<Bitmap, kLevels> blocks;  ///< where blocks of 2, 4 and 8 cells a side are covered
  UncoveredRows uncovered;             ///< of the cover
  std::vector<RankRange> ranges;       ///< by site: directions that it meets; none if it is reflex
  RunTree edges;
  RunTree vertices;
  std::vector<RunPair> pairs;        ///< to begin with
  std::vector<RunScratch> searches;  ///< by thread
  std::vector<Segment> visible;
  std::vector<std::uint32_t> begin;      ///< by site: where its segments begin in `visible`
  std::vector<std::size_t> end_of_task;  ///< by task: where its segments end in `visible`
};

/// Lists the segments that may touch uncovered cells of an active cover, in the convolution's
/// order. It leaves out most of those that lie, with a margin, in covered cells. Throws
/// Error(kLimitExceeded) if more segments are visible than `limits` allows.
///
/// In a sum P ⊕ P it also leaves out copies (see `is_copy`).
///
/// If the convolution is listed, each segment is tested. Otherwise both operands' sites are put
/// into trees of runs along their rings. A run of edges has their box and directions. A run of
/// convex vertices has their box and the directions that they meet. A run of edges and a run of
/// vertices have only hidden segments if the sum of their boxes is covered. They have no segments
/// if no direction is met. Otherwise the larger run is divided. So hidden segments are dropped run
/// by run, and the work depends on the visible ones. Of two leaves, each segment is tested.
[[nodiscard]] std::span<const Segment> visible_segments(const Operands& operands,
                                                        const Convolution& convolution,
                                                        const Cover& cover, const Limits& limits,
                                                        Cancellation& cancellation,
                                                        VisibleScratch& scratch);

}  // namespace minksum

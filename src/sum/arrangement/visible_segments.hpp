// Which segments may touch uncovered cells. Hidden ones are dropped by runs, never one by one, if
// there are many.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sum/convolution/convolution.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

/// A box in cells of the cover's grid.
struct CellBounds {
  float x0, y0, x1, y1;
};

/// A site, and the box of its edge, in cells; rounded.
struct CellSite {
  float x, y;
  CellBounds box;
};

/// A run of an operand's sites: of its edges, or of its convex vertices.
struct SiteRun {
  CellBounds box;
  RankRange directions;  ///< has those of the edges, or those that the vertices meet
};

/// All runs of an operand's edges or vertices: leaves of a few sites each, then pairs of them, and
/// so on.
struct RunTree {
  static constexpr SiteId kLeaf = 8;
  SiteId begin = 0;  ///< the operand's sites
  SiteId end = 0;
  /// Level by level, the leaves first: an even number, but for the root.
  std::vector<SiteRun> runs;
  std::vector<std::uint32_t> level_begin;
};

/// A run of edges, and one of vertices.
struct RunPair {
  std::array<std::uint32_t, 2> run;
  std::array<std::uint32_t, 2> level;
};

/// Memory for the search.
struct VisibleScratch {
  static constexpr std::size_t kLevels = 3;
  std::vector<CellSite> sites;
  /// Where blocks of 2, 4, 8 cells a side are covered; then nothing.
  std::array<Bitmap, kLevels + 1> blocks;
  std::vector<std::uint32_t> uncovered;  ///< cells below and to the left of each corner
  std::vector<RankRange> ranges;  ///< by site: directions that it meets; none if it is reflex
  RunTree edges;
  RunTree vertices;
  std::vector<RunPair> pairs;
  std::vector<Segment> found;
  std::vector<Segment> visible;
  std::vector<std::uint32_t> place;  ///< by site: where its segments are in `visible`
};

/// Whether a cover has anything.
[[nodiscard]] bool covers_any(const Cover& cover);

/// All segments but such as lie, with a margin, in covered cells of an active cover: most of those.
/// In the order in which they are listed.
///
/// If the convolution is listed, each segment is looked at. Else both operands' sites are arranged
/// in trees by runs along their rings, with the boxes and directions of their edges, and the boxes
/// of their convex vertices with the directions that these meet. Of two runs, one of edges, one of
/// vertices, all segments are hidden if the sum of their boxes is covered, and there are none if no
/// direction is met; else the larger is divided. So hidden segments are dropped run by run, and
/// what the search takes depends on those that are visible. Throws Error(kLimitExceeded) for more
/// visible ones than `limits` allows.
[[nodiscard]] std::span<const Segment> visible_segments(const Operands& operands,
                                                        const Convolution& convolution,
                                                        const Cover& cover, const Limits& limits,
                                                        Cancellation& cancellation,
                                                        VisibleScratch& scratch);

}  // namespace minksum

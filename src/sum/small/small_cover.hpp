// Finds cells that lie inside a small sum, so that segments in them can be left out.
#pragma once

#include <array>
#include <vector>

#include "sum/convolution/convolution.hpp"
#include "sum/cover/cover.hpp"
#include "sum/small/small_segments.hpp"
#include "sum/small/small_sum.hpp"

namespace minksum {

/// By vertex of an operand: those after and before it.
struct SmallLinks {
  std::vector<SiteId> next;
  std::vector<SiteId> previous;
};
/// Links the vertices of all rings, or of the outer one.
void link_rings(const SmallOperand& operand, bool with_holes, SmallLinks& links);

/// A cover, and the memory for it.
struct SmallCover {
  Cover cover;
  CoverScratch scratch;
  std::array<SmallLinks, 2> links;  ///< of both operands
  UncoveredRows uncovered;          ///< of the cover, while hidden segments are dropped
  BoughtGrids bought;
  double crossings;  ///< about how many each segment has, or 0
};

/// Marks cells inside the sum if the segments have many crossings, and if that is cheap beside
/// arranging them. Sums of few segments have no cover, and their crossings are not estimated.
void cover_small(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
                 SmallCover& cover);

/// Marks cells of a finer grid, or of a first one, if that is cheap beside `price`: what the walk
/// takes with the cover as it is, in words moved. Returns whether it did. The rings must be linked,
/// as `SmallClipper` and `link_rings` do.
[[nodiscard]] bool refine_cover(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
                                double price, SmallCover& cover);

/// Finds the parts of segments that may be boundary.
class SmallClipper {
 public:
  /// `width` is the larger extent of the sum.
  SmallClipper(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q, double width,
               SmallCover& cover);
  /// Leaves out those that have none.
  void clip(SmallSegments& segments) const;

 private:
  SegmentClipper clipper_;
  std::array<SegmentClipper::Rings, 2> rings_;
  const Cover& cover_;
  double slack_;  ///< more than what boxes are rounded by, here and when they are stored
};

}  // namespace minksum

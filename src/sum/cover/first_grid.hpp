// Chooses the first grid of a cover by what rasterising both operands takes.
#pragma once

#include "sum/cover/cover.hpp"

namespace minksum {

inline constexpr int kFinestSide = 4096;
static_assert(kFinestSide + 1 <= UniformGrid::kMaxSide);

/// Chooses the cells along the side of the first grid that has more. Moving bitmaps of s cells a
/// side costs in proportion to s^3. The share of segments that stay visible is in proportion to 1 /
/// s. The total cost is least where s^4 is in proportion to all segments.
[[nodiscard]] int first_side(std::uint64_t segments);

/// The grids that the cover of a sum may have, and what they cost. All have cells of one shape,
/// which suits the operands' edges.
class GridsOfSum {
 public:
  explicit GridsOfSum(const EdgesOfOperands& edges);
  /// Returns the grid over the sum's box with so many cells along the side that has more of them.
  [[nodiscard]] UniformGrid of(int side) const {
    return UniformGrid::over(sum_extent(edges_), side, stretch_);
  }
  /// Returns about how many cells along that side are as large as the smaller operand, rounded
  /// down; at most kFinestSide + 1. No translate of the smaller operand covers a larger cell.
  /// Translates of the other one hide few segments with such cells, because its edges lie next to
  /// the border of each translate.
  [[nodiscard]] int coarsest_useful_side() const;
  /// Returns what rasterising both operands takes, in words moved. Moving a word takes some
  /// 0.14 ns.
  [[nodiscard]] double price_of_rasters(const UniformGrid& grid) const;
  [[nodiscard]] const EdgesOfOperands& edges() const { return edges_; }

 private:
  EdgesOfOperands edges_;
  double count_ = 0;  ///< of all edges
  double run_ = 0;    ///< widths of all edges together
  double rise_ = 0;   ///< heights of all edges together
  double stretch_ = 1;
};

/// Both operands, rasterised on a grid.
struct Rasters {
  int side;      ///< cells along the side that has more
  double spent;  ///< in words moved
  double words;  ///< how many `spread_rasters` will move
};
/// Rasterises both operands for a grid of `side` cells along a side, or for a finer one:
/// two, four, eight ... times as fine, if it has a price of at most `most` and hardly takes longer.
/// (An edge has the same price on each grid, so many short edges make a fine grid hardly dearer.)
/// If a finer grid would move more words than it saves of about `segments` segments, the coarse one
/// is rasterised after all. Then `spent` has the price of both.
[[nodiscard]] Rasters rasterise_from(int side, double most, double segments,
                                     const GridsOfSum& grids, Cancellation& cancellation,
                                     CoverScratch& scratch);

}  // namespace minksum

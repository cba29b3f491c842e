#include "sum/cover/first_grid.hpp"

#include <algorithm>
#include <cmath>

namespace minksum {

int first_side(std::uint64_t segments) {
  // The mean of the benchmark's regrets is 1.17 with 8, 1.14 to 1.16 with 12, 1.28 with 17.
  constexpr double kSide = 12;
  const double side = kSide * std::sqrt(std::sqrt(static_cast<double>(segments)));
  return std::min(static_cast<int>(side), kFinestSide);
}

GridsOfSum::GridsOfSum(const EdgesOfOperands& edges) : edges_(edges) {
  CellShape shape;
  for (const EdgesOfOperand& o : edges) {
    double run = 0;
    double rise = 0;
    for (SiteId e = o.begin; e < o.end; ++e) {
      run += std::abs(o.x[o.next[e]] - o.x[e]);
      rise += std::abs(o.y[o.next[e]] - o.y[e]);
    }
    const auto count = static_cast<double>(o.end - o.begin);
    shape.add(count, run, rise);
    count_ += count;
    run_ += run;
    rise_ += rise;
  }
  stretch_ = shape.stretch();
}

int GridsOfSum::coarsest_useful_side() const {
  const auto longer = [&](const Vec<double>& v) { return std::max(v.x, v.y * stretch_); };
  const double smaller = std::min(longer(edges_[0].extent), longer(edges_[1].extent));
  return static_cast<int>(std::min(longer(sum_extent(edges_)) / smaller, kFinestSide + 1.0));
}

double GridsOfSum::price_of_rasters(const UniformGrid& grid) const {
  // By least squares over 240 pairs on three grids each: 14 ns for an edge, 4.5 ns for each row of
  // cells that it passes, 0.3 ns for each column, and 4 ns for a word of a bitmap. Covers, and
  // tables of their rows, take about as long for a word. A cell has a number in the arrangement.
  constexpr double kEdge = 100;
  constexpr double kRowOfEdge = 30;
  constexpr double kColumnOfEdge = 2;
  constexpr double kWordOfBitmap = 60;
  constexpr double kCell = 1;
  const auto words = static_cast<double>(words_per_row(grid.columns)) * (grid.rows + 3);
  return kEdge * count_ + kRowOfEdge * rise_ * grid.inverse.y +
         kColumnOfEdge * run_ * grid.inverse.x + kWordOfBitmap * words +
         kCell * static_cast<double>(grid.size());
}

Rasters rasterise_from(int side, double most, double segments, const GridsOfSum& grids,
                       Cancellation& cancellation, CoverScratch& scratch) {
  // With 1.3, 1,161 sums took 0.99 of the time that they take without finer grids. Twelve took
  // under 0.77 of it, and none over 1.2. With 1.2 fewer gained, and with 1.5 some took 1.3 times
  // as long.
  constexpr double kHardlyMore = 1.3;
  // A finer grid saves rasterising the coarse one, and what fewer visible segments take: about this
  // many words for each segment, by the cells along a side of the coarse grid, less by
  // those of the finer one. By the prices of what grids leave of 216 sums, nine tenths save over
  // 6,000, and half over 60,000. Their grids, rasters and arrangements were timed one by one: the
  // mean regret would be 1.11 with 7,000 to 120,000.
  constexpr double kSavedBySegment = 15000;
  const auto price = [&](int of) { return grids.price_of_rasters(grids.of(of)); };
  const double coarse = price(side);
  const double limit = std::min(most, kHardlyMore * coarse);
  Rasters result{side, 0, 0};
  while (2 * result.side <= kFinestSide && price(2 * result.side) <= limit) {
    result.side *= 2;
  }
  for (;; result.side = side) {
    result.spent += price(result.side);
    result.words =
        static_cast<double>(rasterise(grids.edges(), grids.of(result.side), cancellation, scratch));
    if (result.side == side) return result;
    const double saved = kSavedBySegment * segments * (1.0 / side - 1.0 / result.side);
    if (result.words <= coarse + saved) return result;
  }
}

}  // namespace minksum

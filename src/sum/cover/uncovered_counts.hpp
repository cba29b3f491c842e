// Recognises boxes of cells that are covered, in constant time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sum/cover/cover.hpp"

namespace minksum {

/// By corner of a cover's grid, the number of uncovered cells below and to the left. A sum of four
/// of these is the number in a box of cells.
class UncoveredCounts {
 public:
  /// Counts in O(cells). `counts` is the memory for that, and must outlive this.
  UncoveredCounts(const Cover& cover, std::vector<std::uint32_t>& counts)
      : last_column_(cover.grid.columns - 1), last_row_(cover.grid.rows - 1),
        stride_(static_cast<std::size_t>(cover.grid.columns) + 1) {
    counts.resize(stride_ * (static_cast<std::size_t>(cover.grid.rows) + 1));
    std::fill_n(counts.begin(), stride_, 0);
    for (std::int32_t j = 0; j <= last_row_; ++j) {
      const std::uint32_t* below = counts.data() + stride_ * static_cast<std::size_t>(j);
      std::uint32_t* above = counts.data() + stride_ * static_cast<std::size_t>(j + 1);
      const std::uint64_t* covered = cover.covered.row(j);
      std::uint32_t in_row = 0;
      above[0] = 0;
      for (std::int32_t i = 0; i <= last_column_; ++i) {
        in_row += static_cast<std::uint32_t>(~covered[i >> 6] >> (i & 63)) & 1U;
        above[i + 1] = below[i + 1] + in_row;
      }
    }
    counts_ = counts.data();
  }
  /// Whether no cell of these columns and rows is uncovered, the last ones included. Cells beyond
  /// the grid's right and top sides are taken for the last ones of the grid.
  [[nodiscard]] bool none_in(std::int32_t left, std::int32_t bottom, std::int32_t right,
                             std::int32_t top) const {
    const auto column = [&](std::int32_t i) {
      return static_cast<std::size_t>(std::min(i, last_column_));
    };
    const auto row = [&](std::int32_t j) { return static_cast<std::size_t>(std::min(j, last_row_)); };
    const std::size_t end = column(right) + 1;
    const std::uint32_t* below = counts_ + stride_ * row(bottom);
    const std::uint32_t* above = counts_ + stride_ * (row(top) + 1);
    return above[end] - above[column(left)] == below[end] - below[column(left)];
  }

 private:
  std::int32_t last_column_;
  std::int32_t last_row_;
  std::size_t stride_;
  const std::uint32_t* counts_ = nullptr;
};

}  // namespace minksum

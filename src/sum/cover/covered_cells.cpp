// Counts the cells of a cover, and checks it.
#include <algorithm>
#include <bit>

#include "machine/make_room.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

std::uint64_t Cover::covered_count() const {
  std::uint64_t count = 0;
  if (active) {
    for (const std::uint64_t word : covered.words()) {
      count += static_cast<std::uint64_t>(std::popcount(word));
    }
  }
  return count;
}

UncoveredCounts::UncoveredCounts(const Cover& cover, Cancellation& cancellation,
                                 std::vector<std::uint32_t>& counts)
    : last_column_(cover.grid.columns - 1),
      last_row_(cover.grid.rows - 1),
      stride_(static_cast<std::size_t>(cover.grid.columns) + 1) {
  resize_in_pieces(counts, stride_ * (static_cast<std::size_t>(cover.grid.rows) + 1), cancellation);
  std::fill_n(counts.begin(), stride_, 0);
  for (std::int32_t j = 0; j <= last_row_; ++j) {
    cancellation.check(stride_);
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

std::optional<std::string> check(const Cover& cover, const Operands& operands) {
  const UniformGrid& grid = cover.grid;
  const Vec<double> extent = operands.sum_extent();
  if (grid.columns * grid.cell < extent.x || grid.rows * grid.cell < extent.y) {
    return "the grid does not span the sum's box";
  }
  if (!cover.active) return std::nullopt;
  if (cover.covered.columns() != grid.columns || cover.covered.rows() != grid.rows) {
    return "the cover is not of the grid's size";
  }
  const std::int32_t right = grid.column(extent.x);
  const std::int32_t top = grid.row(extent.y);
  for (std::int32_t j = 0; j < grid.rows; ++j) {
    for (std::int32_t i = 0; i < grid.columns; ++i) {
      const bool at_border = i == 0 || j == 0 || i >= right || j >= top;
      if (at_border && cover.is_covered(i, j)) return "a cell at the border of the sum is covered";
    }
  }
  return std::nullopt;
}

}  // namespace minksum

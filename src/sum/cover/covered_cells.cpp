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

void UncoveredRows::unite(const Cover& cover, Cancellation& cancellation) {
  last_column_ = cover.grid.columns - 1;
  last_row_ = cover.grid.rows - 1;
  words_ = cover.covered.words_per_row();
  const auto rows = static_cast<std::size_t>(cover.grid.rows);
  const auto levels = static_cast<std::size_t>(std::bit_width(rows));
  // Level k has 2^k - 1 rows fewer than the first one.
  const std::size_t all = (rows + 1) * levels + 1 - (std::size_t{1} << levels);
  resize_in_pieces(memory_, words_ * all, cancellation);
  std::uint64_t* to = memory_.data();
  rows_[0] = to;
  for (const std::uint64_t covered : cover.covered.words()) *to++ = ~covered;
  for (std::size_t level = 1; level < levels; ++level) {
    const std::size_t half = words_ << (level - 1);
    const std::size_t size = words_ * (rows + 1) - 2 * half;
    const std::uint64_t* const from = rows_[level - 1];
    cancellation.check(size);
    for (std::size_t i = 0; i < size; ++i) to[i] = from[i] | from[i + half];
    rows_[level] = to;
    to += size;
  }
}

std::optional<std::string> check(const Cover& cover, const Operands& operands) {
  const UniformGrid& grid = cover.grid;
  const Vec<double> extent = operands.sum_extent();
  if (grid.columns * grid.cell.x < extent.x || grid.rows * grid.cell.y < extent.y) {
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

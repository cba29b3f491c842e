#include "validation/bin_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace minksum {
namespace {

/// Throws if all cells together have too many entries. One cell cannot, because it has an edge
/// once.
void limit_entries(const OperandScratch& scratch) {
  if (scratch.cell_entries.size() <= std::numeric_limits<std::uint32_t>::max()) return;
  throw Error(ErrorCode::kLimitExceeded,
              "the edges of an operand pass 2^32 cells of a grid or more");
}

}  // namespace

void bin_edges(const PreparedOperand& operand, const UniformGrid& grid, Cancellation& cancellation,
               OperandScratch& scratch) {
  auto& entries = scratch.cell_entries;
  auto& begin = scratch.cell_begin;
  entries.clear();
  begin.assign(static_cast<std::size_t>(grid.size()) + 2, 0);
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto enter = [&](std::int32_t i, std::int32_t j, SiteId e) {
    const std::uint32_t cell =
        static_cast<std::uint32_t>(j) * columns + static_cast<std::uint32_t>(i);
    cancellation.check();
    entries.emplace_back(cell, e);
    ++begin[cell + 2];
    return true;
  };
  const auto& [x, y, dx, dy, next] = operand.sites;
  const double margin = UniformGrid::kMargin * grid.cell;
  for (SiteId e = 0; e < operand.size(); ++e) {
    const SiteId f = next[e];
    const std::int32_t left = grid.column(std::min(x[e], x[f]) - margin);
    const std::int32_t right = grid.column(std::max(x[e], x[f]) + margin);
    const std::int32_t bottom = grid.row(std::min(y[e], y[f]) - margin);
    const std::int32_t top = grid.row(std::max(y[e], y[f]) + margin);
    // Hardly a cell of a short edge's box is far from the edge.
    if (right - left <= 1 && top - bottom <= 1) {
      for (std::int32_t j = bottom; j <= top; ++j) {
        for (std::int32_t i = left; i <= right; ++i) enter(i, j, e);
      }
    } else {
      grid.walk({x[e], y[e]}, {x[f], y[f]}, UniformGrid::kMargin,
                [&](std::int32_t i, std::int32_t j) { return enter(i, j, e); });
    }
  }
  limit_entries(scratch);
  cancellation.check(entries.size());
  for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
  scratch.in_cells.resize(entries.size());
  for (const auto& [cell, e] : entries) scratch.in_cells[begin[cell + 1]++] = e;
  begin.pop_back();
}

}  // namespace minksum

#include "validation/bin_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "machine/make_room.hpp"

namespace minksum {
namespace {

/// Calls visit(edge, cell) for the cells of all edges, edge by edge.
template <class Visit>
void for_each_entry(const PreparedOperand& operand, const UniformGrid& grid, Visit visit) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto enter = [&](std::int32_t i, std::int32_t j, SiteId e) {
    visit(e, static_cast<std::uint32_t>(j) * columns + static_cast<std::uint32_t>(i));
    return true;
  };
  const auto& [x, y, dx, dy, next] = operand.sites;
  const Vec<double> margin{UniformGrid::kMargin * grid.cell.x, UniformGrid::kMargin * grid.cell.y};
  for (SiteId e = 0; e < operand.size(); ++e) {
    const SiteId f = next[e];
    const std::int32_t left = grid.column(std::min(x[e], x[f]) - margin.x);
    const std::int32_t right = grid.column(std::max(x[e], x[f]) + margin.x);
    const std::int32_t bottom = grid.row(std::min(y[e], y[f]) - margin.y);
    const std::int32_t top = grid.row(std::max(y[e], y[f]) + margin.y);
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
}

}  // namespace

void bin_edges(const PreparedOperand& operand, const UniformGrid& grid, Cancellation& cancellation,
               OperandScratch& scratch) {
  auto& begin = scratch.cell_begin;
  assign_in_pieces(begin, static_cast<std::size_t>(grid.size()) + 2, 0U, cancellation);
  std::uint64_t entries = 0;
  for_each_entry(operand, grid, [&](SiteId, std::uint32_t cell) {
    cancellation.check();
    ++begin[cell + 2];
    ++entries;
  });
  if (entries > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::kLimitExceeded,
                "the edges of an operand pass 2^32 cells of a grid or more");
  }
  cancellation.check(begin.size());
  for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
  resize_in_pieces(scratch.in_cells, entries, cancellation);
  for_each_entry(operand, grid, [&](SiteId e, std::uint32_t cell) {
    cancellation.check();
    scratch.in_cells[begin[cell + 1]++] = e;
  });
  begin.pop_back();
}

}  // namespace minksum

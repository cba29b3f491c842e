#include "sum/cover/shared_raster.hpp"

#include <algorithm>

namespace minksum {
namespace {

/// Lays a grid over the sum's box. `cell` is a cell's size in the regions' unit of length.
UniformGrid grid_over(const Operands& o, const Vec<double>& cell) {
  UniformGrid grid;
  grid.cell = {cell.x / o.trace_unit, cell.y / o.trace_unit};
  grid.inverse = {o.trace_unit / cell.x, o.trace_unit / cell.y};
  const auto count = [](double cells) {
    return static_cast<std::int32_t>(std::min(cells, 2.0 * UniformGrid::kMaxSide)) + 1;
  };
  grid.columns = count(o.sum_extent().x * grid.inverse.x);
  grid.rows = count(o.sum_extent().y * grid.inverse.y);
  return grid;
}

/// Whether scaling by `factor` is exact up to rounding.
bool is_usable(double factor) { return factor > 0x1p-900 && factor < 0x1p900; }

}  // namespace

std::optional<SharedRaster> share_raster(const Operands& operands, double widest,
                                         const SumSettings& options, Cancellation& cancellation,
                                         CoverScratch& scratch, Convolution& convolution) {
  Cover cover;
  cover_interior(operands, options, cancellation, scratch, convolution, cover);
  if (!cover.by_translates || !cover.covers_any()) return std::nullopt;
  SharedRaster shared;
  const Vec<double>& cell = cover.grid.cell;
  shared.cell = {cell.x * operands.trace_unit, cell.y * operands.trace_unit};
  if (!is_usable(shared.cell.x) || !is_usable(shared.cell.y) || !is_usable(operands.trace_unit)) {
    return std::nullopt;
  }
  const double columns = operands.extent[0].x * cover.grid.inverse.x + widest / shared.cell.x + 1;
  if (!(columns < UniformGrid::kMaxSide)) return std::nullopt;
  const Visibility typical =
      look(take_sample(operands, convolution, scratch), cover, cancellation, scratch);
  shared.visible = typical.share * static_cast<double>(convolution.size);
  shared.crossings = typical.crossings;
  cover.covered.reset(cover.grid.columns, cover.grid.rows,
                      words_per_row(static_cast<std::int32_t>(columns)));
  rasterise_first(operands, cover, cancellation, scratch.boundary[0], shared.first);
  return shared;
}

void cover_interior(const Operands& operands, const SharedRaster& shared,
                    const SumSettings& options, Cancellation& cancellation, CoverScratch& scratch,
                    Convolution& convolution, Cover& cover) {
  const auto cover_without = [&] {
    cover_interior(operands, options, cancellation, scratch, convolution, cover);
  };
  if (convolution.size == 0 || !is_usable(operands.trace_unit)) return cover_without();
  cover.grid = grid_over(operands, shared.cell);
  const std::size_t words = shared.first.inside.words_per_row();
  if (words_per_row(cover.grid.columns) > words || cover.grid.rows > UniformGrid::kMaxSide) {
    return cover_without();
  }
  cover.active = true;
  cover.clips = false;
  cover.by_translates = true;
  cover.covered.reset(cover.grid.columns, cover.grid.rows, words);
  cover_by_translates(operands, shared.first, cancellation, scratch, cover);
  const auto size = static_cast<double>(convolution.size);
  const Visibility seen =
      look(take_sample(operands, convolution, scratch), cover, cancellation, scratch);
  cover.by_cells = pays_by_cells(operands, size, cover.grid, seen);
  if (!cover.covered.has_any() || seen.share * size > 1.5 * shared.visible + 0.1 * size ||
      seen.crossings > 2 * shared.crossings + 0.5 * size) {
    cover_without();
  }
}

}  // namespace minksum

#include "cover/cover.hpp"

#include <algorithm>
#include <cmath>

namespace minksum {
namespace {

/// Below this many segments a cover costs more than it saves.
constexpr std::size_t kSegmentsWorthACover = 400;

/// Cells along the longer side: about as many cells in all as a third of the segments.
int choose_side(std::size_t segments, const Options& options) {
  if (options.grid > 0) return std::min(options.grid, 2048);
  const double side = 0.6 * std::sqrt(static_cast<double>(segments));
  return std::clamp(static_cast<int>(side), 1, 2048);
}

/// A site's place in its operand's own raster.
Vec<double> at(const Operands& o, SiteId v) { return {o.sites.x[v], o.sites.y[v]}; }

/// Turns toggles along rows into the parity to their right: even-odd filling.
void fill_between_toggles(Bitmap& bitmap) {
  for (std::int32_t j = 0; j < bitmap.rows(); ++j) {
    std::uint64_t carry = 0;
    std::uint64_t* row = bitmap.row(j);
    for (std::size_t w = 0; w < bitmap.words_per_row(); ++w) {
      std::uint64_t parity = row[w];
      for (int shift = 1; shift < 64; shift *= 2) parity ^= parity << shift;
      row[w] = parity ^ carry;
      carry = (row[w] >> 63) != 0 ? ~std::uint64_t{0} : 0;
    }
  }
}

/// The cells of one operand that are inside it, margin and all.
///
/// Cells within 4 · kMargin of an edge are out. Any other cell lies with its margin on one side of
/// the boundary, and the parity at its centre tells which: rounding moves edges by far less.
class Rasteriser {
 public:
  Rasteriser(const Operands& o, int operand, double cell, CoverScratch& scratch)
      : o_(o), begin_(operand == 0 ? 0 : o.split), end_(operand == 0 ? o.split : o.size()),
        inside_(scratch.inside[operand]), boundary_(scratch.boundary) {
    const Vec<double> extent = o.extent[static_cast<std::size_t>(operand)];
    grid_.cell = cell;
    grid_.inverse = 1 / cell;
    grid_.columns = static_cast<std::int32_t>(extent.x * grid_.inverse) + 2;
    grid_.rows = static_cast<std::int32_t>(extent.y * grid_.inverse) + 2;
  }

  void run() {
    inside_.reset(grid_.columns, grid_.rows);
    boundary_.reset(grid_.columns, grid_.rows);
    for (SiteId e = begin_; e < end_; ++e) {
      const Vec<double> a = at(o_, e);
      const Vec<double> b = at(o_, o_.sites.next[e]);
      grid_.walk(a, b, 4 * UniformGrid::kMargin, [&](std::int32_t i, std::int32_t j) {
        boundary_.set(i, j);
        return true;
      });
      toggle(a, b);
    }
    fill_between_toggles(inside_);
    for (std::int32_t j = 0; j < inside_.rows(); ++j) {
      for (std::size_t w = 0; w < inside_.words_per_row(); ++w) {
        inside_.row(j)[w] &= ~boundary_.row(j)[w];
      }
    }
  }

 private:
  /// Flips the cell where the edge crosses the centre line of each row. That cell is near the edge,
  /// so what it is itself does not matter.
  void toggle(Vec<double> a, Vec<double> b) {
    if (a.y > b.y) std::swap(a, b);
    const double y0 = a.y * grid_.inverse;
    const double y1 = b.y * grid_.inverse;
    // Rows j with y0 <= j + 1/2 < y1.
    const auto first = static_cast<std::int32_t>(std::ceil(y0 - 0.5));
    const auto last = static_cast<std::int32_t>(std::ceil(y1 - 0.5));
    for (std::int32_t j = std::max(first, 0); j < std::min(last, grid_.rows); ++j) {
      const double t = std::clamp((j + 0.5 - y0) / (y1 - y0), 0.0, 1.0);
      const std::int32_t i = grid_.column(a.x + t * (b.x - a.x));
      inside_.row(j)[i >> 6] ^= std::uint64_t{1} << (i & 63);
    }
  }

  const Operands& o_;
  SiteId begin_;
  SiteId end_;
  UniformGrid grid_;
  Bitmap& inside_;
  Bitmap& boundary_;
};

/// target |= source moved by (columns, rows).
void unite_moved(const Bitmap& source, std::int32_t columns, std::int32_t rows, Bitmap& target) {
  const std::int32_t first = std::max(0, -rows);
  const std::int32_t last = std::min(source.rows(), target.rows() - rows);
  const auto words = static_cast<std::size_t>(columns >> 6);
  const int bits = columns & 63;
  const std::size_t count =
      std::min(source.words_per_row(), target.words_per_row() - std::min(words, target.words_per_row()));
  for (std::int32_t j = first; j < last; ++j) {
    const std::uint64_t* from = source.row(j);
    std::uint64_t* to = target.row(j + rows) + words;
    if (bits == 0) {
      for (std::size_t w = 0; w < count; ++w) to[w] |= from[w];
      continue;
    }
    for (std::size_t w = 0; w < count; ++w) to[w] |= from[w] << bits;
    const std::size_t spill = std::min(count, target.words_per_row() - words - 1);
    for (std::size_t w = 0; w < spill; ++w) to[w + 1] |= from[w] >> (64 - bits);
  }
}

/// Cells that are inside together with their right, upper and upper right neighbours.
void make_blocks(const Bitmap& inside, Bitmap& block) {
  block.reset(inside.columns(), inside.rows());
  const std::size_t words = inside.words_per_row();
  const auto across = [&](std::int32_t j, std::size_t w) {
    const std::uint64_t* row = inside.row(j);
    const std::uint64_t next = w + 1 < words ? row[w + 1] : 0;
    return row[w] & ((row[w] >> 1) | (next << 63));
  };
  for (std::int32_t j = 0; j + 1 < inside.rows(); ++j) {
    for (std::size_t w = 0; w < words; ++w) block.row(j)[w] = across(j, w) & across(j + 1, w);
  }
}

/// Marks what the interior of `moved` covers when it is moved by points of the other operand.
class Spreader {
 public:
  Spreader(const Operands& o, int moved, CoverScratch& scratch, Cover& cover)
      : o_(o), other_(1 - moved), inside_(scratch.inside[moved]),
        other_inside_(scratch.inside[1 - moved]), block_(scratch.block),
        sampled_(scratch.sampled), cover_(cover) {}

  void run() {
    make_blocks(inside_, block_);
    by_lattice_points();
    by_boundary_points();
  }

 private:
  /// Corners of cells inside the other operand are points of it, and moves by them keep the raster
  /// aligned. Those around which all four cells are inside add little.
  void by_lattice_points() {
    for (std::int32_t j = 0; j <= other_inside_.rows(); ++j) {
      for (std::int32_t i = 0; i <= other_inside_.columns(); ++i) {
        const int around = cell(i - 1, j - 1) + cell(i, j - 1) + cell(i - 1, j) + cell(i, j);
        if (around > 0 && around < 4) unite_moved(inside_, i, j, cover_.covered);
      }
    }
  }
  [[nodiscard]] int cell(std::int32_t i, std::int32_t j) const {
    return i >= 0 && j >= 0 && i < other_inside_.columns() && j < other_inside_.rows() &&
                   other_inside_.get(i, j)
               ? 1
               : 0;
  }

  /// One point of the other's boundary for each cell that has one. A cell moved back by such a point
  /// lies in a block of four cells.
  void by_boundary_points() {
    sampled_.reset(other_inside_.columns(), other_inside_.rows());
    const SiteId begin = other_ == 0 ? 0 : o_.split;
    const SiteId end = other_ == 0 ? o_.split : o_.size();
    const double inverse = cover_.grid.inverse;
    for (SiteId e = begin; e < end; ++e) {
      const Vec<double> a = at(o_, e);
      const Vec<double> b = at(o_, o_.sites.next[e]);
      const double cells = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) * inverse;
      const int steps = static_cast<int>(cells) + 1;
      for (int k = 0; k < steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        sample((a.x + t * (b.x - a.x)) * inverse, (a.y + t * (b.y - a.y)) * inverse);
      }
    }
  }
  void sample(double x, double y) {
    const auto i = static_cast<std::int32_t>(std::floor(x));
    const auto j = static_cast<std::int32_t>(std::floor(y));
    if (i < 0 || j < 0 || i >= sampled_.columns() || j >= sampled_.rows() || sampled_.get(i, j)) {
      return;
    }
    sampled_.set(i, j);
    unite_moved(block_, i + 1, j + 1, cover_.covered);
  }

  const Operands& o_;
  int other_;
  const Bitmap& inside_;
  const Bitmap& other_inside_;
  Bitmap& block_;
  Bitmap& sampled_;
  Cover& cover_;
};

}  // namespace

void cover_interior(const Operands& operands, std::size_t segments, const Options& options,
                    CoverScratch& scratch, Cover& cover) {
  const Vec<double> extent{operands.extent[0].x + operands.extent[1].x,
                           operands.extent[0].y + operands.extent[1].y};
  cover.grid = UniformGrid::over(extent.x, extent.y, choose_side(segments, options));
  // The full convolution is there to be compared: its whole arrangement is built.
  cover.active = options.cover && options.method != Method::kFull &&
                 (options.grid > 0 || segments >= kSegmentsWorthACover);
  if (!cover.active) return;
  cover.covered.reset(cover.grid.columns, cover.grid.rows);
  for (const int operand : {0, 1}) {
    Rasteriser(operands, operand, cover.grid.cell, scratch).run();
  }
  for (const int moved : {0, 1}) Spreader(operands, moved, scratch, cover).run();
}

std::uint64_t Cover::covered_count() const {
  std::uint64_t count = 0;
  for (std::int32_t j = 0; j < grid.rows; ++j) {
    for (std::int32_t i = 0; i < grid.columns; ++i) count += is_covered(i, j) ? 1U : 0U;
  }
  return count;
}

std::optional<std::string> check(const Cover& cover, const Operands& operands) {
  const UniformGrid& grid = cover.grid;
  const double width = operands.extent[0].x + operands.extent[1].x;
  const double height = operands.extent[0].y + operands.extent[1].y;
  if (grid.columns * grid.cell < width || grid.rows * grid.cell < height) {
    return "the grid does not span the sum's box";
  }
  if (!cover.active) return std::nullopt;
  if (cover.covered.columns() != grid.columns || cover.covered.rows() != grid.rows) {
    return "the cover is not of the grid's size";
  }
  const std::int32_t right = grid.column(width);
  const std::int32_t top = grid.row(height);
  for (std::int32_t j = 0; j < grid.rows; ++j) {
    for (std::int32_t i = 0; i < grid.columns; ++i) {
      const bool at_border = i == 0 || j == 0 || i >= right || j >= top;
      if (at_border && cover.is_covered(i, j)) return "a cell at the border of the sum is covered";
    }
  }
  return std::nullopt;
}

}  // namespace minksum

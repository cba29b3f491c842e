#include "cover/cover.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace minksum {
namespace {

/// Below this many segments a cover costs more than it saves.
constexpr std::size_t kSegmentsWorthACover = 400;
constexpr int kMaxSide = 2048;
static_assert(kMaxSide + 1 <= UniformGrid::kMaxSide);

/// Cells along the longer side to begin with: about as many cells in all as a third of the segments.
int choose_side(std::size_t segments, const Options& options) {
  if (options.grid > 0) return std::min(options.grid, kMaxSide);
  const double side = 0.6 * std::sqrt(static_cast<double>(segments));
  return std::clamp(static_cast<int>(side), 1, kMaxSide / 4);
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
  Rasteriser(const Operands& o, int operand, const Cover& cover, CoverScratch& scratch)
      : o_(o), begin_(operand == 0 ? 0 : o.split), end_(operand == 0 ? o.split : o.size()),
        inside_(scratch.inside[operand]), boundary_(scratch.boundary) {
    const Vec<double> extent = o.extent[static_cast<std::size_t>(operand)];
    grid_.cell = cover.grid.cell;
    grid_.inverse = cover.grid.inverse;
    grid_.columns = static_cast<std::int32_t>(extent.x * grid_.inverse) + 2;
    grid_.rows = static_cast<std::int32_t>(extent.y * grid_.inverse) + 2;
    words_ = cover.covered.words_per_row();
  }

  void run() {
    inside_.reset(grid_.columns, grid_.rows, words_);
    boundary_.reset(grid_.columns, grid_.rows, words_);
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
    for (std::size_t w = 0; w < inside_.words().size(); ++w) {
      inside_.words()[w] &= ~boundary_.words()[w];
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
  std::size_t words_;
  Bitmap& inside_;
  Bitmap& boundary_;
};

/// The rows in which a bitmap has anything.
struct RowRange {
  std::int32_t first = 0;
  std::int32_t last = 0;
};
RowRange occupied_rows(const Bitmap& bitmap) {
  const auto empty = [&](std::int32_t j) {
    return std::all_of(bitmap.row(j), bitmap.row(j) + bitmap.words_per_row(),
                       [](std::uint64_t word) { return word == 0; });
  };
  RowRange rows{0, bitmap.rows()};
  while (rows.first < rows.last && empty(rows.first)) ++rows.first;
  while (rows.first < rows.last && empty(rows.last - 1)) --rows.last;
  return rows;
}

/// target |= source moved by (columns, rows), neither negative. Both have rows of equal length, and
/// what is set in the source stays within the target's columns: so rows need not be told apart.
void unite_moved(const Bitmap& source, const RowRange& occupied, std::int32_t columns,
                 std::int32_t rows, Bitmap& target) {
  const std::size_t words = source.words_per_row();
  if (words != target.words_per_row()) {
    throw Error(ErrorCode::kInternal, "rows of different lengths", {}, "cover");
  }
  const auto first = static_cast<std::size_t>(occupied.first) * words;
  const auto last = static_cast<std::size_t>(occupied.last) * words;
  const std::size_t offset = static_cast<std::size_t>(rows) * words + static_cast<std::size_t>(columns >> 6);
  if (first == last || first + offset >= target.words().size()) return;
  const std::size_t count = std::min(last - first, target.words().size() - offset - first);
  const std::uint64_t* __restrict from = source.words().data() + first;
  std::uint64_t* __restrict to = target.words().data() + first + offset;
  const int bits = columns & 63;
  if (bits == 0) {
    for (std::size_t w = 0; w < count; ++w) to[w] |= from[w];
    return;
  }
  to[0] |= from[0] << bits;
  for (std::size_t w = 1; w < count; ++w) to[w] |= (from[w] << bits) | (from[w - 1] >> (64 - bits));
  if (first + offset + count < target.words().size()) to[count] |= from[count - 1] >> (64 - bits);
}

/// Marks what the interior of `moved` covers when it is moved by points of the other operand.
class Spreader {
 public:
  Spreader(const Operands& o, int moved, CoverScratch& scratch, Cover& cover)
      : o_(o), other_(1 - moved), inside_(scratch.inside[moved]),
        other_inside_(scratch.inside[1 - moved]), block_(scratch.block),
        sampled_(scratch.sampled), cover_(cover) {}

  void run() {
    occupied_ = occupied_rows(inside_);
    if (occupied_.first == occupied_.last) return;
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
        if (around > 0 && around < 4) unite_moved(inside_, occupied_, i, j, cover_.covered);
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
    unite_moved(block_, occupied_, i + 1, j + 1, cover_.covered);
  }

  const Operands& o_;
  int other_;
  const Bitmap& inside_;
  const Bitmap& other_inside_;
  Bitmap& block_;
  Bitmap& sampled_;
  Cover& cover_;
  RowRange occupied_;
};

void lay_grid(const Operands& operands, int side, Cover& cover) {
  const Vec<double> extent{operands.extent[0].x + operands.extent[1].x,
                           operands.extent[0].y + operands.extent[1].y};
  cover.grid = UniformGrid::over(extent.x, extent.y, side);
  if (!cover.active) return;
  // An operand's raster may have one column more than the sum's grid; rows must be equally long.
  cover.covered.reset(cover.grid.columns, cover.grid.rows,
                      (static_cast<std::size_t>(cover.grid.columns) + 1 + 63) / 64);
}

void cover_by_translates(const Operands& operands, int side, CoverScratch& scratch,
                         Cover& cover) {
  lay_grid(operands, side, cover);
  if (!cover.active) return;
  for (const int operand : {0, 1}) Rasteriser(operands, operand, cover, scratch).run();
  for (const int moved : {0, 1}) Spreader(operands, moved, scratch, cover).run();
  make_blocks(cover.covered, cover.block);
}

/// How a sample of the segments fares under a cover.
struct Visibility {
  double share = 0;    ///< of segments that touch an uncovered cell
  double crowding = 0; ///< segments to an uncovered cell, on average
};
Visibility look(const Operands& o, std::span<const Segment> segments, const Cover& cover) {
  const std::size_t step = segments.size() / 256 + 1;
  std::size_t visible = 0;
  std::size_t cells = 0;
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < segments.size(); i += step) {
    const auto [e, v] = segments[i];
    const Vec<double> a = at(o, e);
    const Vec<double> b = at(o, o.sites.next[e]);
    const Vec<double> q = at(o, v);
    const std::size_t before = cells;
    cover.grid.walk({a.x + q.x, a.y + q.y}, {b.x + q.x, b.y + q.y}, UniformGrid::kMargin,
                    [&](std::int32_t column, std::int32_t row) {
                      cells += cover.is_covered(column, row) ? 0U : 1U;
                      return true;
                    });
    visible += cells > before ? 1U : 0U;
    ++looked_at;
  }
  const double uncovered = static_cast<double>(static_cast<std::uint64_t>(cover.grid.size()) -
                                               cover.covered_count());
  return {static_cast<double>(visible) / static_cast<double>(looked_at),
          static_cast<double>(cells * step) / std::max(uncovered, 1.0)};
}

/// About how many words a cover of this many cells along a side moves, per segment.
double words_per_segment(int side, std::size_t segments) {
  const double words_per_move = static_cast<double>(side) * side / 128;
  const double moves = 6.0 * side;
  return words_per_move * moves / static_cast<double>(segments);
}

}  // namespace

void make_blocks(const Bitmap& inside, Bitmap& block) {
  block.reset(inside.columns(), inside.rows(), inside.words_per_row());
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

namespace {

// Narrow shapes have no cells inside until cells are small. A finer grid costs little where many
// segments would otherwise stay, or crowd in few cells, as long as it does uncover less.
Visibility refine(const Operands& operands, std::span<const Segment> segments, int& side,
                  CoverScratch& scratch, Cover& cover) {
  constexpr double kTooManyVisible = 0.4;
  constexpr double kFewVisible = 0.1;
  constexpr double kCrowded = 4;
  constexpr double kWorthIt = 0.8;
  constexpr double kMaxWordsPerSegment = 400;
  Visibility now = look(operands, segments, cover);
  while ((now.share > kTooManyVisible || (now.share > kFewVisible && now.crowding > kCrowded)) &&
         side * 2 <= kMaxSide &&
         words_per_segment(side * 2, segments.size()) <= kMaxWordsPerSegment) {
    side *= 2;
    cover_by_translates(operands, side, scratch, cover);
    const Visibility finer = look(operands, segments, cover);
    // A cover that hides nothing yet may hide much on the next grid.
    const bool enough = finer.share > kWorthIt * now.share && now.share < 0.9;
    now = finer;
    if (enough) break;
  }
  return now;
}

/// Cells along the side of the finest level: a power of two. Few cells come to that level.
std::int32_t choose_division(std::size_t segments, const Options& options) {
  constexpr std::uint32_t kMostCells = 4096;
  const double wanted =
      options.grid > 0 ? options.grid : 6.0 * std::sqrt(static_cast<double>(segments));
  return static_cast<std::int32_t>(
      std::min(std::bit_ceil(static_cast<std::uint32_t>(wanted)), kMostCells));
}

bool has_holes(const Operands& operands) {
  return std::any_of(operands.rings.begin(), operands.rings.end(),
                     [](const OperandRing& ring) { return ring.is_hole(); });
}

}  // namespace

void cover_interior(const Operands& operands, const Convolution& convolution,
                    const Options& options, CoverScratch& scratch, Cover& cover) {
  const std::span<const Segment> segments = convolution.segments;
  cover.divided = false;
  // The full convolution is there to be compared: its whole arrangement is built.
  cover.active = options.cover && options.method != Method::kFull &&
                 (options.grid > 0 || segments.size() >= kSegmentsWorthACover);
  int side = choose_side(segments.size(), options);
  cover_by_translates(operands, side, scratch, cover);
  if (!cover.active || segments.empty()) return;
  const bool free_side = options.grid == 0;
  const Visibility seen = free_side ? refine(operands, segments, side, scratch, cover)
                              : look(operands, segments, cover);
  constexpr double kCrowdedForWinding = 5;
  if (seen.crowding <= kCrowdedForWinding || has_holes(operands)) return;
  divide_by_winding(operands, convolution, options.limits,
                    choose_division(segments.size(), options), scratch, cover);
}

std::uint64_t Cover::covered_count() const {
  std::uint64_t count = 0;
  if (active) {
    for (const std::uint64_t word : covered.words()) {
      count += static_cast<std::uint64_t>(std::popcount(word));
    }
  }
  return count;
}

namespace {

std::optional<std::string> check_leaves(const Cover& cover) {
  std::uint32_t end = 0;
  for (const CoverLeaf& leaf : cover.leaves) {
    if (leaf.column < 0 || leaf.row < 0 || leaf.column >= cover.grid.columns ||
        leaf.row >= cover.grid.rows || cover.is_covered(leaf.column, leaf.row)) {
      return "a leaf is where none can be";
    }
    if (leaf.end < end) return "the leaves' lists overlap";
    end = leaf.end;
  }
  if (end != cover.leaf_segments.size()) return "the leaves do not use up their lists";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> check(const Cover& cover, const Operands& operands) {
  const UniformGrid& grid = cover.grid;
  const double width = operands.extent[0].x + operands.extent[1].x;
  const double height = operands.extent[0].y + operands.extent[1].y;
  if (grid.columns * grid.cell < width || grid.rows * grid.cell < height) {
    return "the grid does not span the sum's box";
  }
  if (!cover.active) return std::nullopt;
  if (cover.divided) {
    if (const auto fault = check_leaves(cover)) return fault;
  }
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

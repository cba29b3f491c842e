// Stage 3: finds cells of a grid that certainly lie inside the sum.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "machine/vectors.hpp"
#include "minksum/testing.hpp"
#include "spatial/box.hpp"
#include "spatial/uniform_grid.hpp"
#include "sum/convolution/convolution.hpp"
#include "sum/cover/member_bitmaps.hpp"

namespace minksum {

/// The grid over the sum's box, and what is known of its cells.
///
/// Every point within 3 · UniformGrid::kMargin cells of a covered cell lies in the interior of the
/// sum. Nothing is known of other cells.
struct Cover {
  UniformGrid grid;
  bool active = false;        ///< whether cells may be covered; if false, none is
  Bitmap covered;             ///< of the grid's size if active
  bool by_translates = true;  ///< whether only translates have marked cells
  bool by_cells = true;       ///< whether crossings are to be looked for cell by cell
  bool clips = false;         ///< whether segments are to be clipped

  [[nodiscard]] std::uint64_t covered_count() const;
  [[nodiscard]] bool covers_any() const { return active && covered.has_any(); }
  [[nodiscard]] bool is_covered(std::int32_t column, std::int32_t row) const {
    return active && covered.get(column, row);
  }
};

/// Which cells of a cover are uncovered: in each row, and in every 2, 4, 8 ... rows together.
class UncoveredRows {
 public:
  /// Unites the rows of a cover that is active, in O(cells log(rows) / 64).
  void unite(const Cover& cover, Cancellation& cancellation);
  /// Whether no cell of these columns and rows is uncovered, the last ones included. Cells beyond
  /// the grid's right and top sides are taken for the last ones of the grid. O(words of a row).
  [[nodiscard]] bool none_in(std::int32_t left, std::int32_t bottom, std::int32_t right,
                             std::int32_t top) const {
    left = std::min(left, last_column_);
    right = std::min(right, last_column_);
    bottom = std::min(bottom, last_row_);
    top = std::min(top, last_row_);
    // As many rows from the bottom as from the top, which together are all of the box.
    const auto height = static_cast<std::uint32_t>(top - bottom + 1);
    const int level = static_cast<int>(std::bit_width(height)) - 1;
    const std::uint64_t* const lower = row(level, bottom);
    const std::uint64_t* const upper = row(level, top + 1 - (std::int32_t{1} << level));
    const auto first = static_cast<std::size_t>(left >> 6);
    const auto last = static_cast<std::size_t>(right >> 6);
    std::uint64_t wanted = ~std::uint64_t{0} << (left & 63);
    std::uint64_t any = 0;
    for (std::size_t w = first; w < last; ++w) {
      any |= (lower[w] | upper[w]) & wanted;
      wanted = ~std::uint64_t{0};
    }
    any |= (lower[last] | upper[last]) & wanted & ~std::uint64_t{0} >> (63 - (right & 63));
    return any == 0;
  }

 private:
  [[nodiscard]] const std::uint64_t* row(int level, std::int32_t j) const {
    return rows_[static_cast<std::size_t>(level)] + words_ * static_cast<std::size_t>(j);
  }

  std::int32_t last_column_ = 0;
  std::int32_t last_row_ = 0;
  std::size_t words_ = 0;  ///< of a row
  std::vector<std::uint64_t> memory_;
  /// Row j of level k has the uncovered cells of the 2^k rows from j on.
  std::array<const std::uint64_t*, 14> rows_{};
  static_assert(UniformGrid::kMaxSide < 1 << 14);
};

/// The edges of an operand, [begin, end). Edge e goes from vertex e to vertex next[e]. The lower
/// left corner of the operand's box is (0, 0).
struct EdgesOfOperand {
  const double* x;  ///< of vertices
  const double* y;
  const SiteId* next;
  SiteId begin;
  SiteId end;
  Vec<double> extent;

  [[nodiscard]] Vec<double> at(SiteId vertex) const { return {x[vertex], y[vertex]}; }
};
using EdgesOfOperands = std::array<EdgesOfOperand, 2>;
/// Returns the size of the sum's box, which starts at (0, 0).
[[nodiscard]] inline Vec<double> sum_extent(const EdgesOfOperands& o) {
  return {o[0].extent.x + o[1].extent.x, o[0].extent.y + o[1].extent.y};
}
[[nodiscard]] EdgesOfOperands edges_of(const Operands& operands);

/// An edge in units of cells.
struct CellEdge {
  Vec<double> start;
  Vec<double> d;
};

/// An operand's cells, on a grid that starts at the lower left corner of the operand's box.
struct OperandRaster {
  Bitmap inside;   ///< cells that lie inside the operand with a margin
  Bitmap blocks;   ///< cells that are inside with their right, upper and upper right neighbours
  Bitmap sampled;  ///< cells in which a boundary point was taken
};

/// An estimate of what a cover leaves of the segments.
struct Visibility {
  double share = 0;              ///< share of segments that touch an uncovered cell
  double near_pairs = 0;         ///< number of pairs of these whose boxes overlap
  double near_in_uncovered = 0;  ///< of these, with the middle of the overlap in an uncovered cell
  double crossings = 0;          ///< number of crossings in uncovered cells
  double rows = 0;  ///< number of rows of cells that visible segments pass; 0 without cells
};

/// A line of the sample, and whether it is seen: it is near an uncovered cell.
struct LookedAt {
  Line line;
  bool seen;
};

/// Memory for the stage.
struct CoverScratch {
  Vectors vectors = widest_vectors();  ///< for inner loops; the result does not depend on it
  OperandRaster raster[2];
  OperandRaster coarser_raster[2];     ///< while a finer grid is tried
  Bitmap boundary[2];                  ///< cells that an operand's boundary may touch
  std::vector<std::uint64_t> widened;  ///< a bitmap united with copies moved by columns
  std::vector<std::uint64_t> row;
  std::vector<HelperBitmap> helpers;  ///< one for each helper
  std::vector<CellEdge> long_edges[2];
  ConvolutionScratch convolution;
  std::vector<Segment> sample;
  std::vector<Line> lines;  ///< of the sample
  std::vector<LookedAt> looked_at;
  std::vector<Line> visible;         ///< the lines of the sample's visible segments
  std::vector<BoxOf<double>> boxes;  ///< of some of these lines
  std::vector<double> weights;       ///< how many segments each of them stands for
  Bitmap known;                      ///< cells that were covered on the grid before
  Bitmap best;                       ///< cells that are covered on the best grid so far
};

/// Chooses the grid by the segments (or as `options.grid` says) and marks cells inside the sum.
///
/// Translates come first, on ever finer grids as long as that pays. Where many thin translates
/// cover the sum, segments still crowd. There parallelograms are tried as well. If the convolution
/// has only counted its segments, and no cell is covered, it lists them now.
void cover_interior(const Operands& operands, const SumSettings& options,
                    Cancellation& cancellation, CoverScratch& scratch, Convolution& convolution,
                    Cover& cover);

/// The grids that `cover_cheaply` has bought for a sum.
struct BoughtGrids {
  int side = 0;      ///< cells along the side of the finest one that has more
  double spent = 0;  ///< for all of them, in words moved
};
/// Marks the cells that translates cover. There are about `segments` segments, which need not be
/// listed yet. `price` is what they take with the cover as it is, in words moved. The grid is finer
/// than those that were bought before, and as fine as it can be for small shares of that price.
/// The cover is not active if no cell is marked. Returns false, and leaves the cover as it was, if
/// no grid is that cheap.
[[nodiscard]] bool cover_cheaply(const EdgesOfOperands& edges, double segments, double price,
                                 Cancellation& cancellation, CoverScratch& scratch,
                                 BoughtGrids& bought, Cover& cover);

/// Some of the convolution's segments. Each stands for `step` of them.
struct Sample {
  std::span<const Line> lines;
  double step = 1;
  double share = 1;  ///< the share of the convolution's segments of which clipping leaves a part

  /// Estimates the number of crossings of all segments from their extents in x and y, and from how
  /// unevenly they are spread. The estimate would be the exact expectation if half of the segments
  /// were horizontal, half vertical, all short, and anywhere in each of 32 by 32 cells.
  [[nodiscard]] double expected_crossings(const Operands& operands) const;
};
/// Takes one of every few segments, so that an estimate takes a small share of the time of a sum:
/// one of 16, but at least `kFewestSampled` and at most `kSample`.
[[nodiscard]] Sample take_sample(const Operands& operands, const Convolution& convolution,
                                 CoverScratch& scratch);
/// What clipping leaves: shares of the segments, and of their length.
struct ClippedShare {
  double segments = 1;
  double length = 1;
};
/// Estimates what clipping leaves from one of every 16 segments of the convolution, or from some
/// 256 of them.
[[nodiscard]] ClippedShare see_clipped(const Operands& operands, const Sample& sample,
                                       Cancellation& cancellation, const CoverScratch& scratch);
/// Clips the segments of a sample, and drops those of which nothing is left.
[[nodiscard]] Sample clipped(const Operands& operands, const Sample& sample,
                             Cancellation& cancellation, CoverScratch& scratch);
/// Returns how many lines `look` compares if so many segments are visible.
[[nodiscard]] double lines_compared(double visible);
/// What cells a line is near, as far as it was followed.
struct CellsNear {
  bool covered = false;
  bool uncovered = false;
  std::uint32_t rows = 0;  ///< that were looked at
};
enum class Until : std::uint8_t { kCovered, kUncovered, kBoth };
/// Follows a line until a covered cell is found, an uncovered one, or both.
[[nodiscard]] CellsNear cells_near(const Cover& cover, const Line& line, Until until);
/// Whether a line is near covered cells only. Looks at the cells of its ends and of its middle, and
/// at all near its box. If some of these are not covered, the halves of the line tell.
[[nodiscard]] bool is_hidden(const Cover& cover, const UncoveredRows& uncovered, const Line& line);
/// Tells whether the crossings of what a cover leaves of so many segments are found sooner cell by
/// cell than among all pairs.
[[nodiscard]] bool pays_by_cells(const Operands& operands, double segments, const UniformGrid& grid,
                                 const Visibility& left);
/// Estimates what a cover leaves of the segments. Crossings are counted in a sample of the visible
/// segments, so that crossings are found even if few segments are visible.
[[nodiscard]] Visibility look(const Sample& sample, const Cover& cover, Cancellation& cancellation,
                              CoverScratch& scratch);

/// Returns how many words a row has if the cover has so many columns. Rows of both rasters and of
/// the cover are equally long, and a raster may have one column more.
[[nodiscard]] std::size_t words_per_row(std::int32_t columns);
/// Rasterises both operands on cells of the grid's size. Returns how many words `spread_rasters`
/// will move: that is known before it is paid. O(cells + n + m).
[[nodiscard]] std::uint64_t rasterise(const EdgesOfOperands& edges, const UniformGrid& grid,
                                      Cancellation& cancellation, CoverScratch& scratch);
/// Marks cells of the cover's grid that lie inside translates of an operand.
///
/// Let C be a cell and q a point of Q. If C − q lies in the interior of P, then C = (C − q) + q
/// lies in the interior of P + q. So C lies in the interior of P ⊕ Q. P's interior is rasterised on
/// cells of the same size. The raster is moved by one point of Q for each cell that has one, runs
/// of cells at a time. The moved rasters are united. The same is done with P and Q exchanged.
/// O(words of a raster · runs of the other).
void spread_rasters(Cancellation& cancellation, CoverScratch& scratch, Cover& cover);
/// Rasterises the second operand and marks cells as above, with a given raster of the first
/// operand. The raster's rows must be as long as the cover's.
void cover_by_translates(const Operands& operands, const OperandRaster& first,
                         Cancellation& cancellation, CoverScratch& scratch, Cover& cover);
/// Rasterises the first operand on cells of the cover's size, in rows as long as the cover's.
/// `boundary` is scratch memory.
void rasterise_first(const Operands& operands, const Cover& cover, Cancellation& cancellation,
                     Bitmap& boundary, OperandRaster& raster);

/// Chooses long edges of both operands for `cover_by_parallelograms`. Returns how many rows of
/// cells that will visit. O(n + m).
///
/// An operand's boundary is parted into 4 · √side stretches, and the longest edge of each is taken.
/// So there are long edges from everywhere. A few of them cover narrow shapes, for which no cell
/// fits inside any translate.
[[nodiscard]] double choose_long_edges(const Operands& operands, const UniformGrid& grid,
                                       CoverScratch& scratch);
/// Marks more cells of the grid: those that lie in e ⊕ f for chosen edges e of P and f of Q.
///
/// If a cell lies in the interior of that parallelogram, e crosses x − f for each x of the cell.
/// Next to that crossing the interiors of P and x − Q meet, so no tight place is covered either.
/// O(rows visited).
void cover_by_parallelograms(Cancellation& cancellation, CoverScratch& scratch, Cover& cover);

/// Makes blocks of twice the side. A block of `side` · `side` cells is one bit, that of its lower
/// left cell; four of them that are set make a greater one.
void unite_blocks(const Bitmap& blocks, std::int32_t side, Bitmap& greater);

/// Returns what is wrong with the cover, or nothing. The cover must fit its grid. It must leave out
/// all cells at the border of the sum's box, where the sum's boundary must be. (Tests check from
/// outside, by exact membership, that covered cells are inside the sum.)
[[nodiscard]] std::optional<std::string> check(const Cover& cover, const Operands& operands);

}  // namespace minksum

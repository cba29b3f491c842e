// Stage 3: finds cells of a grid that certainly lie inside the sum.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "machine/vectors.hpp"
#include "minksum/testing.hpp"
#include "spatial/uniform_grid.hpp"
#include "sum/convolution/convolution.hpp"
#include "sum/cover/bitmap.hpp"
#include "sum/cover/classify.hpp"

namespace minksum {

/// A square of cells that a division left uncovered. Its segments are listed in
/// `Cover::leaf_segments`, from the end of the leaf before it to its own.
struct QuadtreeLeaf {
  std::int32_t column;  ///< of the lower left cell
  std::int32_t row;
  std::int32_t side;  ///< in cells
  std::uint32_t end;
};

/// The grid over the sum's box, and what is known of its cells.
///
/// Every point within 3 · UniformGrid::kMargin cells of a covered cell lies in the interior of the
/// sum. Nothing is known of other cells.
///
/// If the cover is divided, the leaves are disjoint, and every point of the sum's boundary is in
/// one. A leaf lists all reduced segments within 3 · UniformGrid::kMargin cells of it. So nobody
/// need walk along segments to find their uncovered cells.
struct Cover {
  UniformGrid grid;
  bool active = false;  ///< whether cells may be covered; if false, none is
  Bitmap covered;       ///< of the grid's size if active
  bool by_translates = true;  ///< whether only translates have marked cells
  bool divided = false;
  std::vector<QuadtreeLeaf> leaves;
  std::vector<std::uint32_t> leaf_segments;  ///< indices into the convolution

  [[nodiscard]] std::uint64_t covered_count() const;
  [[nodiscard]] bool is_covered(std::int32_t column, std::int32_t row) const {
    return active && covered.get(column, row);
  }
};

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
  double share = 0;      ///< share of segments that touch an uncovered cell
  double crowding = 0;   ///< average number of segments in an uncovered cell
  double crossings = 0;  ///< rough number of crossings in uncovered cells
};

/// Memory for the stage.
struct CoverScratch {
  Vectors vectors = widest_vectors();  ///< for inner loops; the result does not depend on it
  OperandRaster raster[2];
  Bitmap boundary;     ///< cells that an operand's boundary may touch
  std::vector<std::uint64_t> widened;  ///< a bitmap united with copies moved by columns
  std::vector<std::uint64_t> row;
  std::vector<CellEdge> long_edges[2];
  ConvolutionScratch convolution;
  std::vector<Segment> sample;
  Convolution reflex;  ///< the rest of the signed convolution
  SegmentStack stack;  ///< segments of the cells under division, list upon list
  Bitmap known;        ///< cells that were covered before the next grid, or a division
};

/// Chooses the grid by the segments (or as `options.grid` says) and marks cells inside the sum.
///
/// Translates come first, on ever finer grids as long as that pays. Segments may still crowd where
/// many thin translates cover the sum rather than few fat ones. There parallelograms are tried as
/// well. If these leave many crossings, the grid is divided by winding number. Segments that are
/// only counted are listed only for a division, or if no cell is covered.
void cover_interior(const Operands& operands, const SumSettings& options,
                    Cancellation& cancellation, CoverScratch& scratch, Convolution& convolution,
                    Cover& cover);

/// Estimates what a cover leaves of the segments, from some hundreds of them.
[[nodiscard]] Visibility look_at_sample(const Operands& operands, const Convolution& convolution,
                                        const Cover& cover, CoverScratch& scratch);

/// Returns the words of a row of each raster, and of a cover of so many columns. An operand's raster
/// may have one column more, but all rows must be equally long.
[[nodiscard]] std::size_t words_per_row(std::int32_t columns);
/// Rasterises both operands on cells of the grid's size. Returns how many words `spread_rasters`
/// will move: that is known before it is paid. O(cells + n + m).
[[nodiscard]] std::uint64_t rasterise(const Operands& operands, const UniformGrid& grid,
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

/// Marks more cells of the grid: those that lie in e ⊕ f for some long edges e of P and f of Q.
///
/// If a cell lies in the interior of that parallelogram, e crosses x − f for each x of the cell.
/// Next to that crossing the interiors of P and x − Q meet, so no tight place is covered either.
/// An operand's boundary is parted into 4 · √side stretches, and the longest edge of each is taken.
/// So there are long edges from everywhere. A few of them cover narrow shapes, for which no cell
/// fits inside any translate. O(n + m + side^2) rows of cells.
void cover_by_parallelograms(const Operands& operands, Cancellation& cancellation,
                             CoverScratch& scratch, Cover& cover);

/// Divides the sum's box into quarters, again and again, and marks cells inside the sum.
///
/// A cell is not divided if it is certainly inside the sum, or if few segments are near it. The
/// smallest cells are those of a grid of `side` · `side` cells (a power of two, at most 4096).
/// Cells that an active cover had before stay covered, as far as whole cells of the new grid go.
///
/// Let K be the signed convolution. Without holes, its winding number w_K(x) is the number of
/// components of P ∩ (x − Q), which is positive inside the sum. Each cell has a list of all
/// segments of K near it, taken from its parent's list. It also has a number computed at its
/// centre c. That number proves which cells are inside:
///
/// 1. Let K' be K with its vertices rounded to integer units, 2^24 to the root's side. Each vertex
///    is rounded once, so K' has closed chains again. Everything about K' is decided exactly: in
///    floats where their rounding cannot matter, else in integers (`classify`).
/// 2. w_K'(c) follows from w_K' at the parent's centre by the segments that cross the way between
///    the two centres. That way stays in the cell, so the cell's list has them. A centre may lie on
///    a segment or in line with a vertex. All centres are taken to be moved by (ε, ε²), which
///    leaves no such case.
/// 3. From K' to K each vertex moves by less than a unit in x and y. Let it move evenly. A segment
///    then sweeps a quadrilateral, whose boundary winds around c at most once. So a *doubtful*
///    segment, one that may come within a unit of c, changes the winding number by at most one.
///    Others do not change it. Hence w_K(c) ≥ w_K'(c) − doubtful.
/// 4. Take a straight way from c to a point y near the cell. On it w_K falls by one at each segment
///    that has c on its left and y on its right, and never otherwise. Such a segment is in the
///    list. Its rounded copy has c on its left, or within the bound of what rounding does to that
///    determinant. Such segments are *losing*. Hence w_K(y) ≥ w_K(c) − losing.
///
/// So a cell with w_K'(c) > doubtful + losing is inside the sum. Tight places are in no such cell:
/// see docs/pipeline.md. Operands must have no (kept) holes. O(entries of all lists).
void divide_by_winding(const Operands& operands, const Convolution& convolution,
                       const Limits& limits, std::int32_t side, Cancellation& cancellation,
                       CoverScratch& scratch, Cover& cover);

/// Sets in `block` the cells that are set in `bitmap` with their right, upper and upper right
/// neighbours.
void make_blocks(const Bitmap& bitmap, Bitmap& block);

/// Returns what is wrong with the cover, or nothing. The cover must fit its grid. It must leave out
/// all cells at the border of the sum's box, where the sum's boundary must be. (Tests check from
/// outside, by exact membership, that covered cells are inside the sum.)
[[nodiscard]] std::optional<std::string> check(const Cover& cover, const Operands& operands);

}  // namespace minksum

// Stage 3: cells of a grid that are certainly inside the sum.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "machine/vectors.hpp"
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

/// The grid over the sum's box and what is known of its cells.
///
/// Of a covered cell every point, and every point within 3 · UniformGrid::kMargin cells of it, is
/// in the interior of the sum. Nothing is known of the others.
///
/// If the cover is divided, the leaves are disjoint, and every point of the sum's boundary is in
/// one. A leaf lists all reduced segments within 3 · UniformGrid::kMargin cells of it: so nobody
/// need look for uncovered cells by walking.
struct Cover {
  UniformGrid grid;
  bool active = false;  ///< false: no cell is covered
  Bitmap covered;       ///< of the grid's size if active
  bool by_translates = true;  ///< nothing else has marked cells
  bool divided = false;
  std::vector<QuadtreeLeaf> leaves;
  std::vector<std::uint32_t> leaf_segments;  ///< indices into the convolution

  [[nodiscard]] std::uint64_t covered_count() const;
  [[nodiscard]] bool is_covered(std::int32_t column, std::int32_t row) const {
    return active && covered.get(column, row);
  }
};

/// An edge, in cells.
struct CellEdge {
  Vec<double> start;
  Vec<double> d;
};

/// An operand on cells, from its own box's lower left corner on.
struct OperandRaster {
  Bitmap inside;   ///< cells that lie inside it, with a margin
  Bitmap blocks;   ///< cells that are inside with their right, upper and upper right neighbours
  Bitmap sampled;  ///< cells in which a boundary point was taken
};

/// How a sample of the segments fares under a cover.
struct Visibility {
  double share = 0;      ///< of segments that touch an uncovered cell
  double crowding = 0;   ///< segments to an uncovered cell, on average
  double crossings = 0;  ///< in uncovered cells, roughly
};

/// Memory for the stage.
struct CoverScratch {
  Vectors vectors = widest_vectors();  ///< of its inner loops; what comes out is always the same
  OperandRaster raster[2];
  Bitmap boundary;     ///< cells that an operand's boundary may touch
  std::vector<std::uint64_t> widened;  ///< a bitmap united with itself moved by columns
  std::vector<std::uint64_t> row;
  std::vector<CellEdge> long_edges[2];
  ConvolutionScratch convolution;
  std::vector<Segment> sample;  ///< of the segments
  Convolution reflex;  ///< the rest of the signed convolution
  SegmentStack stack;  ///< segments of the cells under division, list upon list
  Bitmap known;        ///< what was covered before a division
};

/// Chooses the grid by the segments (or as `options.grid` says) and marks cells: by translates on
/// ever finer grids as long as that pays; where segments still crowd, because the sum is covered by
/// many thin translates rather than few fat ones, by parallelograms as well; and where that leaves
/// many crossings, by winding number. Segments that are not listed stay so, but for a division, or
/// where no cell is covered.
void cover_interior(const Operands& operands, const Options& options, Cancellation& cancellation,
                    CoverScratch& scratch, Convolution& convolution, Cover& cover);

/// What a cover leaves of the segments, by a look at some hundreds of them.
[[nodiscard]] Visibility look_at_sample(const Operands& operands, const Convolution& convolution,
                                        const Cover& cover, CoverScratch& scratch);

/// Marks cells of the grid as it is laid.
///
/// If a cell C, moved by −q for a point q of Q, lies in the interior of P, then C = (C − q) + q
/// lies in the interior of P + q, and so of P ⊕ Q. So: rasterise P's interior on cells of the same
/// size, move that by one point of Q for each cell that has one, runs of them at a time, unite; the
/// same with P and Q exchanged. O(words of a raster · runs of the other).
void cover_by_translates(const Operands& operands, Cancellation& cancellation,
                         CoverScratch& scratch, Cover& cover);
/// The same with a raster of the first operand, of rows as long as the cover's.
void cover_by_translates(const Operands& operands, const OperandRaster& first,
                         Cancellation& cancellation, CoverScratch& scratch, Cover& cover);
/// The first operand on cells of the cover's size, in rows as long as its. `boundary` is memory.
void rasterise_first(const Operands& operands, const Cover& cover, Cancellation& cancellation,
                     Bitmap& boundary, OperandRaster& raster);

/// Marks more cells of the grid: those that lie in e ⊕ f for some long edges e of P and f of Q.
///
/// If a cell lies in the interior of that parallelogram, e crosses x − f for each x of the cell:
/// then the interiors of P and x − Q meet next to where they do. So no tight place is covered
/// either. An operand's edges are taken in 4 · √side stretches, and of each the longest: long ones
/// from everywhere. Narrow shapes are covered by few of these, where no cell fits inside any
/// translate. O(n + m + side^2) rows of cells.
void cover_by_parallelograms(const Operands& operands, Cancellation& cancellation,
                             CoverScratch& scratch, Cover& cover);

/// Divides the sum's box into quarters, again and again, until a cell is certainly inside the sum,
/// few segments are near it, or it is one of `side` · `side` (a power of two, at most 4096). What
/// an active cover has covered before stays covered, as far as whole cells of the new grid go.
///
/// Let K be the signed convolution. Without holes its winding number w_K(x) is the number of
/// components of P ∩ (x − Q): positive inside the sum. Each cell has the list of all of K that is
/// near it, taken from its parent's list, and a number computed at its centre c. That is proof:
///
/// 1. Let K' be K with its vertices rounded to integer units, 2^24 to the root's side, each vertex
///    once: closed chains again. Everything about K' is decided exactly, in floats where their
///    rounding cannot matter, else in integers (`classify`).
/// 2. w_K'(c) follows from w_K' at the parent's centre by the segments that cross the way between
///    the two, which stays in the cell: so they are in its list. A centre on a segment or in line
///    with a vertex is taken to be moved by (ε, ε²), all centres alike, which leaves no such case.
/// 3. From K' to K each vertex moves by less than a unit in x and y. Let it do so evenly. A segment
///    sweeps a quadrilateral, whose boundary winds around c at most once: so each that may come
///    within a unit of c, a *doubtful* one, changes the winding number by one at most; others by
///    none. w_K(c) ≥ w_K'(c) − doubtful.
/// 4. On a straight way from c to a point y near the cell, w_K falls by one for each segment that
///    has c on its left and y on its right, and never otherwise. Such a segment is in the list, and
///    its rounded double has c on its left or within the bound of what rounding does to that
///    determinant: a *losing* one. w_K(y) ≥ w_K(c) − losing.
///
/// So a cell with w_K'(c) > doubtful + losing is inside the sum. Tight places are in none: see
/// docs/pipeline.md. Operands must have no (kept) holes. O(entries of all lists).
void divide_by_winding(const Operands& operands, const Convolution& convolution,
                       const Limits& limits, std::int32_t side, Cancellation& cancellation,
                       CoverScratch& scratch, Cover& cover);

/// Cells that are set together with their right, upper and upper right neighbours.
void make_blocks(const Bitmap& bitmap, Bitmap& block);

/// Whether the cover fits its grid and leaves out all cells at the border of the sum's box, where
/// the sum's boundary must be; what is wrong, if not. (That covered cells are inside the sum is
/// tested from outside, by exact membership.)
[[nodiscard]] std::optional<std::string> check(const Cover& cover, const Operands& operands);

}  // namespace minksum

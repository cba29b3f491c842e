// Shares the raster of the first operand between sums with second operands of about one size, such
// as the turns of one robot.
#pragma once

#include <optional>

#include "minksum/testing.hpp"
#include "sum/cover/cover.hpp"

namespace minksum {

/// A raster of the first operand, with cells of one size for all sums.
struct SharedRaster {
  Vec<double> cell{};    ///< a cell's width and height, in the regions' unit of length
  double visible = 0;    ///< estimate of the visible segments of the typical sum
  double crossings = 0;  ///< estimate of the crossings of the typical sum
  OperandRaster first;  ///< narrow holes are kept: what fits into them depends on the other operand
};

/// Makes the raster that a typical sum's own cover would have. Its rows are long enough for second
/// operands up to the width `widest`, in the regions' unit of length. Returns nothing if translates
/// alone did not make that cover, if the cover is empty, or if rows would be too long. `operands`
/// must be combined with NarrowHoles::kKeep, and `convolution` is theirs, as for `cover_interior`.
[[nodiscard]] std::optional<SharedRaster> share_raster(const Operands& operands, double widest,
                                                       const SumSettings& options,
                                                       Cancellation& cancellation,
                                                       CoverScratch& scratch,
                                                       Convolution& convolution);

/// Covers the sum as `cover_interior` does, but with a given raster of the first operand. The
/// raster is not used if cells do not fit, or if it leaves much more than in the typical sum.
void cover_interior(const Operands& operands, const SharedRaster& shared,
                    const SumSettings& options, Cancellation& cancellation, CoverScratch& scratch,
                    Convolution& convolution, Cover& cover);

}  // namespace minksum

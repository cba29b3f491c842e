// A cover's raster of the first operand, for its sums with others of about one size: with one that
// turns.
#pragma once

#include <optional>

#include "sum/cover/cover.hpp"

namespace minksum {

/// Cells of one size for all sums.
struct SharedRaster {
  double cell = 0;      ///< a cell's side, in the regions' unit of length
  double visible = 0;   ///< segments of the typical sum, about
  double crossings = 0;
  OperandRaster first;  ///< with narrow holes: what fits into them depends on the second operand
};

/// The raster that a typical sum's own cover would have, in rows that are long enough for second
/// operands of this width, in the regions' unit of length. Nothing if that cover has other than
/// translates, or nothing at all, or if rows would be too long. The operands are combined with
/// NarrowHoles::kKeep, the convolution is theirs, as for `cover_interior`.
[[nodiscard]] std::optional<SharedRaster> share_raster(const Operands& operands, double widest,
                                                       const Options& options,
                                                       Cancellation& cancellation,
                                                       CoverScratch& scratch,
                                                       Convolution& convolution);

/// `cover_interior` with a raster of the first operand: where that leaves much more than in the
/// typical sum, and where cells do not fit, as without.
void cover_interior(const Operands& operands, const SharedRaster& shared, const Options& options,
                    Cancellation& cancellation, CoverScratch& scratch, Convolution& convolution,
                    Cover& cover);

}  // namespace minksum

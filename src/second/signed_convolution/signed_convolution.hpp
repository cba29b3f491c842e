// Declares the signed method: an independent way to the Minkowski sum, which checks the fast
// method.
//
//   operands ─► segments ─► closed chains ─► overlay
//
// It shares nothing with the fast method but the rooms below both. The fast method keeps only
// segments that can bound the sum, and tests its loops for collisions. The signed method keeps all
// segments, with signs, and the overlay counts how often they wind around each face. The signed
// method is slower, because it builds the whole arrangement, and simpler to be sure of.
#pragma once

#include <span>

#include "minksum/testing.hpp"
#include "second/signed_convolution/operands.hpp"

namespace minksum {

/// Sets `result` to P ⊕ Q by signed convolution and winding numbers. The regions must be valid (see
/// `validate`). The result is in canonical form, without origins.
void signed_convolution_sum(const Region& p, const Region& q, const SumSettings& options,
                            Statistics& statistics, Region& result);

/// Sets `result` to the sum of a valid region and polylines. They are those of a resolved Geometry.
void signed_convolution_sum(const Region& p, std::span<const Polyline> q,
                            const SumSettings& options, Region& result);

/// Sets `result` to the sum of two unions of such polylines. Edges of different directions sweep
/// the region. Each pair of parallel edges adds a segment, which may overlap with others and the
/// region.
void signed_convolution_sum(std::span<const Polyline> p, std::span<const Polyline> q,
                            const SumSettings& options, Geometry& result);

}  // namespace minksum

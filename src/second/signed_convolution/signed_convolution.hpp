// The signed method: an independent way to the Minkowski sum, the fast method's check.
//
//   operands ─► segments ─► arrangement ─► winding ─► rings
//
// It shares no code with the fast method but the numbers and regions at the library's boundary.
// Where the fast method keeps only segments that can bound the sum and tests what it finds for
// collisions, this one keeps all segments with signs and counts how often they wind around each
// face. Slower, as the whole arrangement is built, and simpler to be sure of.
#pragma once

#include <span>

#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// P ⊕ Q by signed convolution and winding numbers. The operands must be valid (see `validate`).
/// `result` is cleared first and written in canonical form, without origins.
void signed_convolution_sum(const Region& p, const Region& q, const Options& options,
                            Statistics& statistics, Region& result);

/// The same for the union of polylines as the second operand, as they are in a resolved Geometry:
/// each is a ring that is walked there and back.
void signed_convolution_sum(const Region& p, std::span<const Polyline> q, const Options& options,
                            Region& result);

/// The sum of two unions of such polylines. The region is what edges of different directions sweep;
/// each pair of parallel edges adds a segment, which may overlap with others and the region.
void signed_convolution_sum(std::span<const Polyline> p, std::span<const Polyline> q,
                            const Options& options, Geometry& result);

}  // namespace minksum

// The signed method: an independent way to the Minkowski sum, the fast method's check.
//
//   operands ─► segments ─► arrangement ─► winding ─► rings
//
// It shares no code with the fast method but the numbers and regions at the library's boundary.
// Where the fast method keeps only segments that can bound the sum and tests what it finds for
// collisions, this one keeps all segments with signs and counts how often they wind around each
// face. Slower, as the whole arrangement is built, and simpler to be sure of.
#pragma once

#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// P ⊕ Q by signed convolution and winding numbers. The operands must be valid (see `validate`).
/// `result` is cleared first and written in canonical form, without origins.
void signed_convolution_sum(const Region& p, const Region& q, const Options& options,
                            Statistics& statistics, Region& result);

}  // namespace minksum

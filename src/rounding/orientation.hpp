// Finds the orientation of a region's rings.
#pragma once

#include "exact/sign.hpp"
#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// Tells whether a ring of a valid region runs counter-clockwise. O(n).
[[nodiscard]] bool counter_clockwise(const Region& region, std::size_t ring,
                                     Cancellation& cancellation);

}  // namespace minksum

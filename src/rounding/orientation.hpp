// Small exact questions about a region's rings and points.
#pragma once

#include "exact/sign.hpp"
#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// Whether a ring of a valid region runs counter-clockwise. O(n).
[[nodiscard]] bool counter_clockwise(const Region& region, std::size_t ring,
                                     Cancellation& cancellation);

}  // namespace minksum

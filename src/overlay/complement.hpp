// Subtracts a region from a box without an overlay.
#pragma once

#include <optional>

#include "minksum/measure.hpp"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// Returns the box less a valid region, in canonical form. The region must not be empty, and its
/// rings must touch neither each other nor the box. Then the result has those of its rings that lie
/// in the box, the other way round, and the rings are copied. A sweep tells, in O(n log n) for n
/// vertices, whether this is so, and which ring is in which. Returns nothing if it is not so, or if
/// a ring does not turn at a vertex. Throws Error(kCancelled).
[[nodiscard]] std::optional<Region> complement_in(const Box& box, const Region& region,
                                                  const Options& options = {});

}  // namespace minksum

// Subtracts a region from a box without an overlay.
#pragma once

#include <optional>

#include "minksum/measure.hpp"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// Returns the box less a valid region, in canonical form, or nothing. The region must touch itself
/// nowhere. Each ring must lie strictly inside the box, but for one that may go around it. Then the
/// result has the region's rings, the other way round. Doubles tell that this is so, and the rings
/// are copied. The time is O(n log n) for n vertices, with next to no arithmetic on exact
/// coordinates. Returns nothing if the conditions do not hold, are not certain, or would take
/// longer to test than an overlay. Throws Error(kCancelled).
[[nodiscard]] std::optional<Region> complement_in(const Box& box, const Region& region,
                                                  const Options& options = {});

}  // namespace minksum

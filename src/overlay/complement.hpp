// What of a box a region leaves free.
#pragma once

#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/measure.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// The box less a valid region, in canonical form, where it has the region's rings, the other way
/// round: if the region touches itself nowhere, and each ring is strictly inside the box, but for
/// one that may be around it. Doubles tell that it is so, and the rings are copied: O(n log n) for
/// n vertices, next to no arithmetic on exact coordinates. Nothing if it is not so, or not certain,
/// or if it would take longer to tell than an overlay takes.
/// Throws Error(kCancelled).
[[nodiscard]] std::optional<Region> complement_in(const Box& box, const Region& region,
                                                  const std::optional<CancelToken>& cancel = {});

}  // namespace minksum

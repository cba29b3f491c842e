// Turns by right angles.
#pragma once

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// The region turned counter-clockwise by `quarters` times 90 degrees; canonical if it was so
/// before. No arithmetic: coordinates change places and signs. Origins are kept. O(n), and
/// sorting of rings.
[[nodiscard]] Region turned(const Region& region, int quarters, Cancellation& cancellation);

/// The same with rings and vertices in the order that they have, and without origins. O(n).
[[nodiscard]] Region turned_in_order(const Region& region, int quarters,
                                     Cancellation& cancellation);

}  // namespace minksum

// Turns regions by right angles.
#pragma once

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// Returns the region turned counter-clockwise by `quarters` times 90 degrees. The result is
/// canonical if the region is. There is no arithmetic: coordinates change places and signs. Origins
/// are kept. Takes O(n), and sorting of rings.
[[nodiscard]] Region turned(const Region& region, int quarters, Cancellation& cancellation);

/// Returns the region with its rings and vertices in canonical order. Outer rings must come first,
/// and all rings must have the canonical direction.
[[nodiscard]] Region in_canonical_order(const Region& region, Cancellation& cancellation);

/// Does the same as `turned`, but keeps the order of rings and vertices, and drops origins. O(n).
[[nodiscard]] Region turned_in_order(const Region& region, int quarters,
                                     Cancellation& cancellation);

}  // namespace minksum

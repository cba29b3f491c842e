// Union, intersection and difference, exactly.
#pragma once

#include <span>

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

// All of these throw Error(kLimitExceeded) for 2^30 vertices or more in all, for more than 2^28
// places where edges cross, or ends of edges that lie on others (those that overlap on one line
// joined first), and where a coordinate of the result has more than 2 million bits; and
// Error(kCancelled).

/// The union of resolved geometries (see Geometry), resolved. They may overlap in any way.
/// O((n + c) log n) for n vertices in all and c places where edges meet, and so for the others.
[[nodiscard]] MINKSUM_API Geometry unite(std::span<const Geometry> geometries,
                                         const Options& options = {});

/// The union of valid regions (see `validate`), as the closure of what has area; and so the results
/// of the operations below.
[[nodiscard]] MINKSUM_API Region unite(const Region& a, const Region& b,
                                       const Options& options = {});
/// What lies in both regions.
[[nodiscard]] MINKSUM_API Region intersect(const Region& a, const Region& b,
                                           const Options& options = {});
/// What lies in `a` and not in `b`.
[[nodiscard]] MINKSUM_API Region subtract(const Region& a, const Region& b,
                                          const Options& options = {});
/// What lies in one of both regions alone.
[[nodiscard]] MINKSUM_API Region symmetric_difference(const Region& a, const Region& b,
                                                      const Options& options = {});

/// Whether a ⊆ b.
[[nodiscard]] MINKSUM_API bool contains(const Region& b, const Region& a,
                                        const Options& options = {});

}  // namespace minksum

// Declares exact unions, intersections and differences.
#pragma once

#include <span>
#include <vector>

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

// Rings of operands may be of any kind: `options.fill` says what they enclose (see `resolve`). By
// kStrict, all of these throw Error(kBadInput) for a ring that is not valid, with the index of the
// operand, polygon, ring and vertex.
//
// All of these throw Error(kCancelled), and Error(kLimitExceeded) in four cases: the operands have
// 2^30 vertices or more in all; edges cross more than Limits::max_crossings times; more than 2^28
// ends of edges lie on other edges, after edges that overlap on one line are joined; a coordinate
// of the result has more than 2 million bits.

/// Returns the union of geometries, resolved (see Geometry). They may overlap in any way. This and
/// the functions below take O((n + c) log n) for n vertices in all and c places where edges meet.
[[nodiscard]] MINKSUM_API Geometry unite(std::span<const Geometry> geometries,
                                         const Options& options = {});

/// Returns the union of two geometries, as above.
[[nodiscard]] inline Geometry unite(const Geometry& a, const Geometry& b,
                                    const Options& options = {}) {
  const Geometry both[] = {a, b};
  return unite(std::span<const Geometry>(both), options);
}
/// Returns the union of any number of regions: the area of what `unite` of geometries returns.
[[nodiscard]] inline Region unite(std::span<const Region> regions, const Options& options = {}) {
  const std::vector<Geometry> all(regions.begin(), regions.end());
  return unite(std::span<const Geometry>(all), options).region;
}
/// Returns the union of two regions. Here and below, the result is valid and canonical (see
/// Region). It is the closure of what has area, so it has no thin parts.
[[nodiscard]] MINKSUM_API Region unite(const Region& a, const Region& b,
                                       const Options& options = {});
/// Returns what lies in both regions.
[[nodiscard]] MINKSUM_API Region intersect(const Region& a, const Region& b,
                                           const Options& options = {});
/// Returns what lies in `a` and not in `b`.
[[nodiscard]] MINKSUM_API Region subtract(const Region& a, const Region& b,
                                          const Options& options = {});
/// Returns what lies in exactly one of the two regions.
[[nodiscard]] MINKSUM_API Region symmetric_difference(const Region& a, const Region& b,
                                                      const Options& options = {});

/// Tells whether a ⊆ b, apart from parts of `a` that have no area. `b` is operand 0 in errors.
[[nodiscard]] MINKSUM_API bool contains(const Region& b, const Region& a,
                                        const Options& options = {});

}  // namespace minksum

// Computes fill rules and boolean operations by the definition, exactly and slowly. Every segment
// is cut by every other, and winding numbers are counted along a ray from a point beside each
// piece. Shares no code with the library beyond its value types.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "minksum/boolean.hpp"
#include "minksum/geometry.hpp"
#include "minksum/resolve.hpp"

namespace minksum::reference {

/// Does the same as minksum::resolve, but with kStrict it takes any region for valid.
[[nodiscard]] Geometry brute_force_resolve(const Geometry& geometry, FillRule rule,
                                           bool regularize = false);

/// Returns the closure of the points on no edge for which `keep(in a, in b)` is true. Regions must
/// be valid.
[[nodiscard]] Region brute_force_boolean(const Region& a, const Region& b,
                                         const std::function<bool(bool, bool)>& keep);

/// Does the same as minksum::unite.
[[nodiscard]] Geometry brute_force_unite(std::span<const Geometry> geometries);

/// Returns why a geometry is not resolved (see Geometry); empty if it is.
[[nodiscard]] std::string resolved_fault(const Geometry& geometry);

}  // namespace minksum::reference

// Fill rules and boolean operations by the definition: every segment is cut by every other, and
// windings are counted along a ray from a point beside each piece. Slow, obvious, exact. Shares no
// code with the library beyond its value types.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "minksum/boolean.hpp"
#include "minksum/geometry.hpp"
#include "minksum/resolve.hpp"

namespace minksum::reference {

/// As minksum::resolve, but for kStrict, which it takes for valid.
[[nodiscard]] Geometry brute_force_resolve(const Geometry& geometry, FillRule rule,
                                           bool regularize = false);

/// The closure of the points for which `keep(in a, in b)` says yes and that are on no edge. Regions
/// must be valid.
[[nodiscard]] Region brute_force_boolean(const Region& a, const Region& b,
                                         const std::function<bool(bool, bool)>& keep);

/// As minksum::unite.
[[nodiscard]] Geometry brute_force_unite(std::span<const Geometry> geometries);

/// Why a geometry is not resolved (see Geometry); empty if it is.
[[nodiscard]] std::string resolved_fault(const Geometry& geometry);

}  // namespace minksum::reference

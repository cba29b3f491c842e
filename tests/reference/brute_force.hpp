// Computes the Minkowski sum and the union by the definition, exactly and slowly. Shares no code
// with the library beyond its value types.
#pragma once

#include "minksum/geometry.hpp"
#include "minksum/region.hpp"

namespace minksum::reference {

/// Returns P ⊕ Q in canonical form, without origins. The sum of two convex pieces is the hull of
/// all sums of their vertices, and P ⊕ Q is the exact union of these. Operands must be valid. Meant
/// for up to a few dozen vertices.
[[nodiscard]] Region brute_force_sum(const Region& p, const Region& q);

/// Does the same for resolved geometries, where segments of polylines and points are convex pieces
/// too. The result is resolved.
[[nodiscard]] Geometry brute_force_sum(const Geometry& p, const Geometry& q);

/// Returns the union of two valid regions, which may overlap.
[[nodiscard]] Region brute_force_union(const Region& a, const Region& b);

}  // namespace minksum::reference

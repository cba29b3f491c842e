// The Minkowski sum and the union by the definition: slow, obvious, exact. Shares no code with the
// library beyond its value types.
#pragma once

#include "minksum/geometry.hpp"
#include "minksum/region.hpp"

namespace minksum::reference {

/// P ⊕ Q: every convex piece of P with every convex piece of Q, as the hull of all sums of their
/// vertices; then the exact union of those. In canonical form, without origins. Operands must be
/// valid. Meant for up to a few dozen vertices.
[[nodiscard]] Region brute_force_sum(const Region& p, const Region& q);

/// The same for resolved geometries: segments of polylines and points are convex pieces too. The
/// result is resolved.
[[nodiscard]] Geometry brute_force_sum(const Geometry& p, const Geometry& q);

/// The union of two valid regions, which may overlap.
[[nodiscard]] Region brute_force_union(const Region& a, const Region& b);

}  // namespace minksum::reference

// Computes tight places by the definition, exactly and slowly. Shares no code with the library
// beyond its value types.
#pragma once

#include "minksum/geometry.hpp"

namespace minksum::reference {

/// Returns the closure of the points in the interior of P ⊕ Q that are not in P° ⊕ Q°. It has
/// polylines and points in canonical form (see Geometry).
///
/// With convex pieces A of P and B of Q, P° ⊕ Q° is the union U of all A° ⊕ B°. The reason: if the
/// insides of P and x − Q meet, they share an open set, so a point inside a piece of each.
/// P ⊕ Q is the union S of all A ⊕ B. The points of S that are not in U lie on edges of these sums.
/// On each edge they are intervals and points that remain after the open sums are removed. They are
/// tight where both sides are in S. Operands must be valid. Meant for up to a few dozen vertices.
[[nodiscard]] Geometry brute_force_tight_places(const Region& p, const Region& q);

}  // namespace minksum::reference

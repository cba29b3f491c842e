// Tight places by the definition: slow, obvious, exact. Shares no code with the library beyond its
// value types.
#pragma once

#include "minksum/geometry.hpp"

namespace minksum::reference {

/// The closure of the points that P ⊕ Q has in its interior and P° ⊕ Q° has not; polylines and
/// points in canonical form (see Geometry).
///
/// With convex pieces A of P and B of Q, P° ⊕ Q° is the union U of all A° ⊕ B°: if the insides of P
/// and x − Q meet, they do in an open set, and so in a point that is inside a piece of each. P ⊕ Q
/// is the union S of all A ⊕ B. What is in S and not in U lies on edges of these sums. On each edge
/// that is the rest when the open sums are taken away: intervals and points. They are tight where
/// both sides are in S. Operands must be valid. Meant for up to a few dozen vertices.
[[nodiscard]] Geometry brute_force_tight_places(const Region& p, const Region& q);

}  // namespace minksum::reference

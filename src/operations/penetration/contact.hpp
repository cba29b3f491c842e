// Declares the search for what is in contact where two regions touch.
#pragma once

#include <optional>

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// Returns an edge of one region and a vertex of the other that lies on it, if B is moved by
/// `shift`. The edge is parallel to `along`. Both are given by indices of vertices, and kFirst is
/// A. Of several pairs, edges of A come first, then those with lower indices, then vertices with
/// lower indices. There is one if `shift` lies on an edge of A ⊕ −B in direction `along`: edges of
/// a sum are pieces of edges of one operand, moved by vertices of the other. O((n + m) log(n + m)),
/// and all vertices on the lines of such edges.
[[nodiscard]] std::optional<EdgeOrigin> find_contact(const Region& a, const Region& b,
                                                     const Point& shift, const Point& along,
                                                     Cancellation& cancellation);

}  // namespace minksum

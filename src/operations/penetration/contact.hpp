// What is in contact where two regions touch.
#pragma once

#include <optional>

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// An edge of one region, in the direction of `along` or against it, and a vertex of the other that
/// lies on it, if B is moved by `shift`: as indices of vertices, kFirst is A. Of several, edges of
/// A come first, then by their index, then by the vertex's. Where `shift` is on an edge of A ⊕ −B
/// in direction `along` there is one: the edges of a sum are pieces of edges of one operand, moved
/// by vertices of the other. O((n + m) log(n + m)), and all vertices on the lines of such edges.
[[nodiscard]] std::optional<EdgeOrigin> find_contact(const Region& a, const Region& b,
                                                     const Point& shift, const Point& along,
                                                     Cancellation& cancellation);

}  // namespace minksum

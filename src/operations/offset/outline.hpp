// Declares outlines whose winding numbers tell what an offset is.
#pragma once

#include <span>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "operations/offset/corners.hpp"

namespace minksum {

/// Adds the offset's outline along a closed path to `outlines`, as one ring. What is on the path's
/// right side is moved outwards. `ends` are the indices of vertices at ends of a polyline, where
/// the path turns back. Successive vertices differ.
///
/// Let A be a region whose boundary ∂A the paths are, counter-clockwise. As chains, the outlines
/// are ∂A, and the boundaries of a strip beside each edge pq and of a fan at each corner v. Let P
/// and Q be the moved p and q. The strip is the quadrilateral p P Q q. The fan is all triangles of
/// v and two successive vectors. All of them go counter-clockwise or have no area: the fans by
/// CornerOutline, and the strips as two such triangles, which is verified.
///
/// In the sum, sides that two pieces have in common cancel: pq of strip and ∂A, vP of strip and
/// fan. So winding numbers are those of A, plus one for each piece around a point. They are
/// positive exactly on the union, except for its boundary. A polyline, there and back, has no area
/// itself. If ∂A is clockwise, as the complement's, they are −1 in A plus that sum: negative in A
/// without the pieces.
void add_outline(const std::vector<Point>& path, std::span<const std::size_t> ends,
                 const Corners& corners, Cancellation& cancellation, Region& outlines);

}  // namespace minksum

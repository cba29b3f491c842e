// Outlines whose winding numbers say what an offset is.
#pragma once

#include <span>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "operations/offset/corners.hpp"

namespace minksum {

/// Adds the offset's outline along a closed path to `outlines`, as one ring: what is on the path's
/// right side is moved outwards. `ends` (indices of vertices) are ends of a polyline, where the
/// path turns back. Successive vertices differ.
///
/// What it is for: let A be a region whose boundary ∂A the paths are, counter-clockwise. As chains,
/// the outlines are ∂A, and the boundaries of a strip beside each edge pq and of a fan at each
/// corner v. With P, Q the moved p, q: the strip is the quadrilateral p P Q q, the fan all
/// triangles of v and two successive vectors. All of them go counter-clockwise or have no area (the
/// fans by CornerOutline; the strips are two such triangles, which is verified). In the sum, sides
/// that two pieces have in common cancel: pq those of strip and ∂A, vP those of strip and fan. So
/// winding numbers are those of A plus one for each piece around a point: positive exactly on the
/// union, but for its boundary. A polyline, there and back, has no area itself. For a clockwise ∂A,
/// the complement's, they are −1 in A plus that sum: negative in A without the pieces.
void add_outline(const std::vector<Point>& path, std::span<const std::size_t> ends,
                 const Corners& corners, Cancellation& cancellation, Region& outlines);

}  // namespace minksum

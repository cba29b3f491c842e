// Moving vertices so that no point of a region is lost, or so that none is won.
#pragma once

#include "minksum/round.hpp"
#include "round/place.hpp"

namespace minksum {

/// Replaces the places of vertices by others next to them, such that the rounded rings enclose the
/// exact region (kOutside), or are enclosed in it (kInside), if they are those of a legal region
/// with the same orientations (see `settle`). Vertices that are exact stay. False if for some vertex
/// no such place is among the corners of the target's cell that it is in; then `vertices` is of no
/// use. O(n).
///
/// Proof (kOutside; kInside is the same for the complement, whose boundary runs the other way). Let
/// every vertex v move in a straight line to its place V = v + d, and every edge with its ends. The
/// winding number of the moving rings around a fixed point x changes only when an edge passes over
/// x, and it grows by one when the edge comes from its own left, which is to say moves to its own
/// right. At time t the edge from p to v, with interior on its left, has direction
/// e(t) = (v − p) + t·(d_v − d_p), and moves to its right, or not at all, if e(t) × d_p ≤ 0 and
/// e(t) × d_v ≤ 0. Both are linear in t: so it is enough that they hold at t = 0 and t = 1. (At the
/// instants, finitely many, at which an edge has no length it covers a single point; a region is the
/// closure of its other points.) These four signs are tested for every edge, exactly. So winding
/// numbers never fall: what had 1 has 1 or more in the end, and the rounded region, if it is legal,
/// is where they are 1.
[[nodiscard]] bool choose_side(const Region& region, RoundingSide side, const Target& target,
                               RoundedVertices& vertices);

}  // namespace minksum

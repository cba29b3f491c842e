// Moves vertices so that no point of a region is lost, or so that none is gained.
#pragma once

#include <optional>

#include "minksum/round.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

struct Sided {
  Region region;            ///< ring by ring; a vertex may have become two
  double largest_move = 0;  ///< in the target's unit, rounded up
};

/// Moves vertices to places of the target so that the moved rings enclose the exact region
/// (kOutside), or lie in it (kInside). The moved rings must be those of a valid region with the
/// same orientations (see `check_topology`). Exact vertices stay. If the target's cells are no
/// larger than `step`, points between an edge and its moved edge are at most √2 · `step` from the
/// edge. `nearest` are the vertices' nearest places. Returns nothing if some vertex finds no place.
/// O(n).
///
/// Proof for kOutside: every vertex v moves in a straight line to its place V = v + d, and edges
/// move with their ends. The winding number of the moving rings around a fixed point x changes only
/// when an edge passes over x. The number grows by one when the edge moves to its own right, from x
/// on its right to x on its left.
///
/// At time t, consider the edge from p to v, with the set to be enclosed on its left. The edge has
/// the direction e(t) = (v − p) + t·(d_v − d_p). The edge moves to its right, or not at all, if
/// e(t) × d_p ≤ 0 and e(t) × d_v ≤ 0. Both products are linear in t, so their signs at the times 0
/// and 1 are enough. At finitely many instants, an edge may have no length and cover a single
/// point. A region is the closure of its other points. The four signs are tested for every edge,
/// exactly. So winding numbers never fall, and a number of 1 is 1 or more in the end. If the moved
/// region is valid, it is where winding numbers are 1.
///
/// kInside is the same for the complement, whose boundary runs the other way.
///
/// A vertex that goes to two places counts as two vertices, with an edge of no length between them.
/// At t = 0, one or two corners of its cell are always good for a convex vertex, because they lie
/// all round it. A reflex vertex may have to go up its notch, to where that is wide enough for a
/// place.
///
/// Points between an edge and its moved edge are in the hull of the edge and the places of its
/// ends. The distance from an edge is a convex function, so it is greatest at one of these places.
[[nodiscard]] std::optional<Sided> choose_side(const Region& region, RoundingSide side,
                                               const Target& target, const RoundedVertices& nearest,
                                               double step, Cancellation& cancellation);

}  // namespace minksum

// Moving vertices so that no point of a region is lost, or so that none is won.
#pragma once

#include <optional>

#include "minksum/round.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

struct Sided {
  Region region;            ///< ring by ring; where one vertex had no place there may be two
  double largest_move = 0;  ///< in the target's unit, rounded up
};

/// Moves vertices to places of the target such that the moved rings enclose the exact region
/// (kOutside), or are enclosed in it (kInside), if they are those of a valid region with the same
/// orientations (see `check_topology`). Vertices that are exact stay. No point between an edge and
/// its moved one is farther than √2 · `step` from the edge, for cells of the target no larger than
/// `step`. `nearest` are the vertices' nearest places. Nothing if some vertex finds no place. O(n).
///
/// Proof (kOutside; kInside is the same for the complement, whose boundary runs the other way). Let
/// every vertex v move in a straight line to its place V = v + d, and every edge with its ends. The
/// winding number of the moving rings around a fixed point x changes only when an edge passes over
/// x, and it grows by one when the edge comes from its own left, which is to say moves to its own
/// right. At time t the edge from p to v, with the set to be enclosed on its left, has direction
/// e(t) = (v − p) + t·(d_v − d_p), and moves to its right, or not at all, if e(t) × d_p ≤ 0 and
/// e(t) × d_v ≤ 0. Both are linear in t: so it is enough that they hold at t = 0 and t = 1. (At the
/// instants, finitely many, at which an edge has no length it covers a single point; a region is
/// the closure of its other points.) These four signs are tested for every edge, exactly. So
/// winding numbers never fall: what had 1 has 1 or more in the end, and the moved region, if it is
/// valid, is where they are 1.
///
/// One vertex may go to two places: it counts as two, with an edge of no length between them. A
/// convex vertex always has one or two corners of its cell to go to, as far as t = 0 goes: they lie
/// all round it. A reflex one may have to go up its notch, to where that is wide enough for a
/// place.
///
/// Points between an edge and its moved one are in the hull of the edge and the places of its ends.
/// The distance from an edge is a convex function, so greatest at one of these places.
[[nodiscard]] std::optional<Sided> choose_side(const Region& region, RoundingSide side,
                                               const Target& target, const RoundedVertices& nearest,
                                               double step, Cancellation& cancellation);

}  // namespace minksum

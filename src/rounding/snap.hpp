// Declares snap rounding, which moves everything to the points of a uniform grid so that nothing
// crosses.
#pragma once

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

/// The points i · step, for integers i. The step is 10^-decimals, or the power of two that is a
/// double's last place at the magnitude of the coordinates. All points of the grid up to a little
/// beyond the coordinates are in the target.
struct SnapGrid {
  Target target;
  int exp2 = 0;  ///< step = 2^exp2, unless decimal
  [[nodiscard]] Rational step() const;
};
[[nodiscard]] SnapGrid snap_grid(const Geometry& geometry, const Target& target,
                                 Cancellation& cancellation);

/// The snapped geometry, resolved.
struct Snapped {
  Geometry geometry;
  bool exact = true;        ///< whether nothing moved
  double largest_move = 0;  ///< rounded up
};

/// Snap-rounds a resolved geometry whose region is canonical. Polylines meet nothing but at ends.
///
/// A pixel is the half-open square of side `step` around a grid point. A *hot* pixel contains a
/// vertex. Each edge becomes the chain of the centres of the hot pixels that it meets, in their
/// order. (J. D. Hobby, "Practical segment intersection with finite precision output", Comput.
/// Geom. 13, 1999; L. Guibas, D. Marimont, "Rounding arrangements dynamically", IJCGA 8, 1998.) The
/// edges meet only at vertices, so chains never cross, by theorem 1 of the latter paper. Chains may
/// coincide.
///
/// Points of an edge move in straight lines. In each hot pixel that the chain visits, one point
/// moves to the centre. Points between these move linearly. So no point moves by more than half a
/// step along an axis. The new region is where the moved rings have a positive winding number. The
/// boundary passed each point that changes sides, so the point is no farther from it than that.
///
/// Takes O(n log n + k) for n vertices and k pairs of an edge and a hot pixel close to each other.
[[nodiscard]] Snapped snap(const Geometry& geometry, const SnapGrid& grid,
                           Cancellation& cancellation);

}  // namespace minksum

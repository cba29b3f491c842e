// Makes a region larger or smaller by half a step of a grid.
#pragma once

#include <optional>

#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// Returns region ⊕ B, where B is the square |x| ≤ half, |y| ≤ half.
///
/// The moved rings of the result still enclose the region if boundary points move by at most `half`
/// along each axis. Proof: let the distance of two points be the larger difference of their
/// coordinates. A boundary point of the result is at least `half` away from each point of the
/// region, and farther from each inner point. So a boundary point that moves in a straight line
/// passes no inner point of the region, and the winding number of such a point stays 1.
[[nodiscard]] Region grown(const Region& region, const Rational& half, const Options& options);

/// Does the same with thin parts, which become area. The moved rings lose no point x of these
/// either, if points move by −half < d ≤ half along each axis. Snapping moves them so (see
/// snap.hpp). In each pixel, one point of each edge goes to the pixel's centre, and other moves are
/// between these.
///
/// Proof: some η > 0 has d > −half + η for all moves. Then no boundary point comes to x + (δ, δ)
/// for 0 < δ < η: it would have to start closer to x than `half`. So these points keep their
/// winding number, and x is in their closure.
[[nodiscard]] Region grown(const Geometry& geometry, const Rational& half, const Options& options);

/// Returns the closure of the set of points x for which B, moved to x, lies in the region. This is
/// the complement of the grown complement of the region. So the proof for `grown` holds here with
/// inside and outside exchanged: moved rings of the result enclose no point outside the region.
[[nodiscard]] Region shrunk(const Region& region, const Rational& half, const Options& options);

}  // namespace minksum

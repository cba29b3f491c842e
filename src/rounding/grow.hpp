// A region made larger or smaller by half a step of a grid.
#pragma once

#include <optional>

#include "minksum/cancel.hpp"
#include "minksum/geometry.hpp"

namespace minksum {

/// region ⊕ B, where B is the square |x| ≤ half, |y| ≤ half. Every boundary point of the result has
/// at least the distance `half` from every point of the region, and more than that from every inner
/// point, in the metric of the larger difference of coordinates. So if boundary points then move by
/// at most `half` along each axis, in straight lines, none passes an inner point of the region, its
/// winding number stays 1, and what the moved rings enclose contains the region.
[[nodiscard]] Region grown(const Region& region, const Rational& half,
                           const std::optional<CancelToken>& cancel);

/// The same with thin parts, which become area. Of these, too, the moved rings lose no point x, if
/// points move by −half < d ≤ half along each axis, as they do by snapping (see snap.hpp: it is
/// enough that each edge has one point in each pixel that goes to its centre, and between these
/// moves are between theirs). As d > −half + η for some η > 0, no boundary point comes to x + (δ,
/// δ) for 0 < δ < η: it would have to be closer to x than `half` at first. So these points keep
/// their winding number, and x is in their closure.
[[nodiscard]] Region grown(const Geometry& geometry, const Rational& half,
                           const std::optional<CancelToken>& cancel);

/// The closure of the points x with x ⊕ B in the region: the complement of its grown complement.
/// What was said of the latter's boundary is true here of points outside the region: moved rings
/// enclose none of them.
[[nodiscard]] Region shrunk(const Region& region, const Rational& half,
                            const std::optional<CancelToken>& cancel);

}  // namespace minksum

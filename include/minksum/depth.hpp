// Declares how two shapes stand to each other: penetration depth, distance and time of impact.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// Tells how A and B stand to each other, and the shortest move that changes that. Lengths are in
/// the unit of the coordinates.
struct Depth {
  /// Whether their interiors meet. For thin parts, which have no interior, see below.
  bool overlapping = false;
  /// The shortest move of B after which B touches A and does not overlap it; (0, 0) if they only
  /// touch already. If several moves are shortest, it is the lexicographically smallest one.
  Point vector;
  Rational squared;     ///< the square of its length, exactly
  double distance = 0;  ///< its length
  /// What is in contact after the move: an edge of one region (kFirst is A), and a vertex of the
  /// other that lies on it, perhaps at its end. Both are indices of vertices as given. If several
  /// pairs are in contact along one line of the sum's boundary, the first is named, A's edges
  /// before B's. It is empty if a shape had to be resolved first, or if the contact is a tight
  /// place.
  std::optional<EdgeOrigin> contact;
};

/// Returns the penetration depth of two overlapping shapes, or the distance of two that are apart.
/// Returns nothing if one is empty. The shapes are read by `options.fill`. They may have holes and
/// several parts, polylines and points, and need not be convex. The result is exact.
///
/// B + t overlaps A if and only if t is in A° ⊕ (−B)°. So the answer is the vector from the origin
/// to the nearest point of that set's boundary, tight places included (Cameron, Culley 1986). The
/// time is that of minkowski_sum, and O(n log n) for the n edges of sum and operands. Throws as
/// minkowski_sum of geometries does.
///
/// B + t meets A if and only if t is in A ⊕ −B. Shapes with thin parts overlap if they still meet
/// after every move that is short enough: if the origin is inside that set. So a point overlaps an
/// area inside of which it lies, and two polylines that cross overlap, but two points, or two
/// polylines on one straight line, only touch. A polyline that just fits between two areas, without
/// play, overlaps them: tight places are those of areas alone.
[[nodiscard]] MINKSUM_API std::optional<Depth> penetration_depth(const Geometry& a,
                                                                 const Geometry& b,
                                                                 const Options& options = {});

/// Returns when B meets A if B moves along `direction`: the smallest factor f ≥ 0 for which B + f ·
/// direction touches or overlaps A. It is 0 if they meet already. Returns nothing if they never
/// meet. Shapes, complexity and errors are as above. A `direction` of (0, 0) is an
/// Error(kBadInput).
[[nodiscard]] MINKSUM_API std::optional<Rational> time_of_impact(const Geometry& a,
                                                                 const Geometry& b,
                                                                 const Point& direction,
                                                                 const Options& options = {});

}  // namespace minksum

// Offsets: a set grown or shrunk by a distance, with round, mitred, square or bevelled corners.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"

namespace minksum {

/// A polygon that stands for the disc of this radius around the origin. With r for the radius, t
/// for the tolerance and B(s) for the disc of radius s:
/// - kOutside: B(r) ⊆ D ⊆ B(r + t);
/// - kInside: B(r − t) ⊆ D ⊆ B(r);
/// - kNearest: B(r − t) ⊆ D ⊆ B(r + t), with about 0.7 times as many vertices.
///
/// Verified for each vertex and each edge by squared distances, exactly.
///
/// D is convex, has the square's symmetries and reaches to exactly r along both axes, so that a sum
/// with it moves axis-parallel edges by exactly r. Its other coordinates are multiples of the
/// largest power of ten ≤ t/64. It has at most 2 % and six more vertices than it would need without
/// all this: about 2.2·√(r/t) for one side. A tolerance of more than r/2 is taken for r/2.
///
/// Throws Error: kBadInput if radius or tolerance is not positive; kLimitExceeded for more than
/// 2^20 vertices.
[[nodiscard]] MINKSUM_API Region disc(const Rational& radius, const Rational& tolerance,
                                      RoundingSide side = RoundingSide::kNearest);

/// What an offset has at corners that it moves apart: an outward one at convex vertices, an inward
/// one at reflex ones, one of a polyline at each bend's outer side.
enum class Join {
  kRound,   ///< an arc around the vertex
  kMiter,   ///< both moved edges up to where they meet; beyond the miter limit as kSquare
  kSquare,  ///< cut at right angles to the bisector, at the distance from the vertex
  kBevel,   ///< cut from the end of one moved edge to that of the other
};
/// "round", "miter", "square", "bevel".
[[nodiscard]] MINKSUM_API const char* to_string(Join join);

/// What an offset has at both ends of a polyline that is not closed, and around points.
enum class Cap {
  kRound,   ///< a semicircle; a disc around a point
  kButt,    ///< nothing: it ends where the polyline ends; points vanish
  kSquare,  ///< it goes on by the distance; an axis-parallel square around a point
};
/// "round", "butt", "square".
[[nodiscard]] MINKSUM_API const char* to_string(Cap cap);

/// What an offset looks like.
struct OffsetOptions {
  Join join = Join::kRound;  ///< at corners
  Cap cap = Cap::kRound;     ///< at ends of polylines, and around points
  /// The farthest that a miter may reach from its vertex, in multiples of the distance; ≥ 1.
  Rational miter_limit = 2;
  /// How far the result may be off, see `offset`; |distance|/1000 if it is not set.
  std::optional<Rational> tolerance = {};
  /// For round joins and caps: kOutside contains the true offset, kInside is contained in it.
  RoundingSide side = RoundingSide::kNearest;
};

/// A grown by `distance` if that is positive, shrunk if it is negative; 0 is `resolve`. A may have
/// holes, several parts, rings of any kind, polylines and points. The result is resolved. Polylines
/// and points grow on all sides; shrinking drops them, as it does with all that has no area in the
/// result.
///
/// With r = |distance|, t the tolerance, and B(s) the disc of radius s:
///
/// - Round joins and caps: the true offset is A ⊕ B(r), or A ⊖ B(r). The result is exactly A ⊕ D or
///   A ⊖ D for a polygon D (see `disc`). Both are monotone in D, so it lies between two offsets:
///
///   ```
///               grown                               shrunk (less what has no area)
///   kOutside    from A ⊕ B(r) to A ⊕ B(r + t)       from A ⊖ B(r) to A ⊖ B(r − t)
///   kInside     from A ⊕ B(r − t) to A ⊕ B(r)       from A ⊖ B(r + t) to A ⊖ B(r)
///   kNearest    from A ⊕ B(r − t) to A ⊕ B(r + t)   from A ⊖ B(r + t) to A ⊖ B(r − t)
///   ```
///
///   Grown, no point of the result or of the true offset is farther than t from the other. Shrunk,
///   that cannot be promised of any polygon D: a neck as wide as 2r is there or not.
///
/// - Other joins or caps: the true result is A and a strip beside each edge and a piece at each
///   corner and end, or A without these. Here all of them have their corners within t of where they
///   belong (normals are irrational). Which corners have pieces and whether miters are within their
///   limit is decided exactly. Grown, no point of the result or of the true one is farther than t
///   from the other; shrunk, so it is with what is taken away. A side other than kNearest is an
///   Error(kBadInput). Polylines are taken as they are given, bends, crossings and all; one that is
///   closed has no caps.
///
/// Axis-parallel edges move by exactly r.
///
/// Time: that of minkowski_sum with D, or of `resolve` for the outlines of all pieces. Throws
/// Error: kBadInput (a tolerance that is not positive, a miter limit below 1, what kStrict finds),
/// kLimitExceeded (also for a tolerance below 10^-10 of the distance times the miter limit
/// squared), kCancelled.
[[nodiscard]] MINKSUM_API Geometry offset(const Geometry& a, const Rational& distance,
                                          const OffsetOptions& shape = {},
                                          const Options& options = {});

}  // namespace minksum

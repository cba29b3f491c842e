// Declares offsets: sets grown or shrunk by a distance, with round, mitred, square or bevelled
// joins.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"

namespace minksum {

/// Returns a convex polygon D that stands for the disc of this radius around the origin. Radius and
/// tolerance are lengths in the unit of the coordinates. With radius r, tolerance t and the disc
/// B(s) of radius s:
/// - kOutside: B(r) ⊆ D ⊆ B(r + t).
/// - kInside: B(r − t) ⊆ D ⊆ B(r).
/// - kNearest: B(r − t) ⊆ D ⊆ B(r + t), with about 0.7 times as many vertices.
///
/// Exact tests of squared distances verify this for each vertex and each edge.
///
/// D has the square's symmetries and reaches to exactly r along both axes. So a sum with D moves
/// axis-parallel edges by exactly r. The other coordinates of D are multiples of the largest power
/// of ten ≤ t/64. D has at most 2 % and six vertices more than it needs without these properties:
/// about 2.2·√(r/t) for one side. A tolerance of more than r/2 is taken as r/2.
///
/// O(√(r/t)). Throws Error: kBadInput if radius or tolerance is not positive; kLimitExceeded for
/// more than 2^20 vertices.
[[nodiscard]] MINKSUM_API Region disc(const Rational& radius, const Rational& tolerance,
                                      RoundingSide side = RoundingSide::kNearest);

/// Says which shape an offset has at corners that it moves apart. These are convex vertices of an
/// outward offset, reflex vertices of an inward one, and a polyline's bends on their outer side.
enum class Join {
  kRound,   ///< an arc around the vertex
  kMiter,   ///< both moved edges up to where they meet; as kSquare beyond the miter limit
  kSquare,  ///< a cut at right angles to the bisector, at the distance from the vertex
  kBevel,   ///< a cut from the end of one moved edge to that of the other
};
/// Returns the join's name: "round", "miter", "square" or "bevel"; or "unknown".
[[nodiscard]] MINKSUM_API const char* to_string(Join join);

/// Says which shape an offset has at both ends of an open polyline, and around points.
enum class Cap {
  kRound,   ///< a semicircle; a disc around a point
  kButt,    ///< nothing: it ends where the polyline ends, and points vanish
  kSquare,  ///< it goes on by the distance; an axis-parallel square around a point
};
/// Returns the cap's name: "round", "butt" or "square"; or "unknown".
[[nodiscard]] MINKSUM_API const char* to_string(Cap cap);

/// Says what an offset looks like.
struct OffsetOptions {
  Join join = Join::kRound;  ///< the shape at corners
  Cap cap = Cap::kRound;     ///< the shape at ends of polylines and around points
  /// The largest distance of a miter from its vertex, divided by the offset's distance; at least 1.
  Rational miter_limit = 2;
  /// How far the result may deviate, see `offset`. If it is not set, it is |distance|/1000.
  std::optional<Rational> tolerance = {};
  /// The side of round joins and caps. The result contains the true offset by kOutside, and is
  /// contained in it by kInside.
  RoundingSide side = RoundingSide::kNearest;
};

/// Returns A grown by `distance` if that is positive, shrunk if it is negative, and resolved if it
/// is 0. A is read by `options.fill`: it may have holes, several parts, rings of any kind,
/// polylines and points. The result is resolved. Polylines and points grow on all sides. Shrinking
/// drops them, and also what has no area in the result. Lengths are in the unit of the coordinates.
///
/// Let r = |distance|, t the tolerance, and B(s) the disc of radius s.
///
/// - Round joins and caps: the true offset is A ⊕ B(r) or A ⊖ B(r). The result is exactly A ⊕ D or
///   A ⊖ D for a polygon D (see `disc`). Both are monotone in D, so the result lies between two
///   offsets:
///
///   ```
///               grown                               shrunk (less what has no area)
///   kOutside    from A ⊕ B(r) to A ⊕ B(r + t)       from A ⊖ B(r) to A ⊖ B(r − t)
///   kInside     from A ⊕ B(r − t) to A ⊕ B(r)       from A ⊖ B(r + t) to A ⊖ B(r)
///   kNearest    from A ⊕ B(r − t) to A ⊕ B(r + t)   from A ⊖ B(r + t) to A ⊖ B(r − t)
///   ```
///
///   If A is grown, no point of the result or of the true offset is farther than t from the other.
///   No polygon D can promise that for a shrunk A: a neck as wide as 2r stays or disappears.
///
/// - Other joins or caps: the true result is A with a strip beside each edge and a piece at each
///   corner and end, or A without these. Normals are irrational, so the corners of strips and
///   pieces are within t of the true ones. Which corners have pieces, and whether miters are within
///   their limit, is decided exactly. If A is grown, no point of the result or of the true one is
///   farther than t from the other. If A is shrunk, that holds for what is taken away. Polylines
///   are taken as given, with bends and crossings, and closed ones have no caps.
///
/// Axis-parallel edges move by exactly r.
///
/// The time is that of minkowski_sum with D, or that of `resolve` for the outlines of all pieces.
/// Throws Error: kBadInput for a tolerance that is not positive, a miter limit below 1, or a side
/// other than kNearest without round joins and caps; kBadInput with culprit operand 0 by kStrict;
/// kLimitExceeded, also for a tolerance below 10^-10 of the distance times the miter limit squared;
/// kCancelled.
[[nodiscard]] MINKSUM_API Geometry offset(const Geometry& a, const Rational& distance,
                                          const OffsetOptions& shape = {},
                                          const Options& options = {});

}  // namespace minksum

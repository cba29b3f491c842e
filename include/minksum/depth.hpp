// Penetration depth, separation distance, time of impact: how two regions stand to each other.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// How A and B stand to each other, and the shortest way to change that.
struct Depth {
  /// Whether their interiors meet.
  bool overlapping = false;
  /// The shortest vector, (0, 0) if they just touch. Overlapping: B moved by it touches A and
  /// overlaps it no more. Apart: B moved by it touches A. Where several are shortest, the
  /// lexicographically smallest.
  Point vector;
  Rational squared;     ///< its length squared, exactly
  double distance = 0;  ///< its length, as a double
  /// What is in contact then: an edge of one (kFirst is A), and a vertex of the other that lies on
  /// it, at an end perhaps; as indices of the vertices given. Of several pairs in contact along one
  /// line of the sum's boundary the first, A's edges before B's. Nothing where shapes had to be
  /// resolved first, or the contact is a tight place.
  std::optional<EdgeOrigin> contact;
};

/// The penetration depth of two overlapping regions, or the distance of two that are apart; nothing
/// if one is empty. Regions may be non-convex, with holes, in several parts. Exact.
///
/// B + t overlaps A if and only if t is in A° ⊕ (−B)°, so that the answer is the vector from the
/// origin to the nearest point of that set's boundary (Cameron, Culley 1986), tight places
/// included. The time is that of minkowski_sum, and O(n log n) for the n edges of sum and operands.
[[nodiscard]] MINKSUM_API std::optional<Depth> penetration_depth(const Geometry& a,
                                                                 const Geometry& b,
                                                                 const Options& options = {});

/// When B moves along `direction`: the smallest factor f ≥ 0 for which B + f·direction touches or
/// overlaps A; nothing if it never does. 0 if they touch or overlap already. `direction` must not
/// be (0, 0): Error(kBadInput).
[[nodiscard]] MINKSUM_API std::optional<Rational> time_of_impact(const Geometry& a,
                                                                 const Geometry& b,
                                                                 const Point& direction,
                                                                 const Options& options = {});

}  // namespace minksum

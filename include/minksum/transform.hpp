// Declares exact moves, turns, mirror images and scalings.
#pragma once

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// The affine map (x, y) ↦ (xx·x + xy·y + dx, yx·x + yy·y + dy).
struct MINKSUM_API Affine {
  Rational xx = 1;   ///< factor of x in the new x
  Rational xy = {};  ///< factor of y in the new x
  Rational dx = {};  ///< summand of the new x
  Rational yx = {};  ///< factor of x in the new y
  Rational yy = 1;   ///< factor of y in the new y
  Rational dy = {};  ///< summand of the new y
  /// Tells whether both are the same map.
  friend bool operator==(const Affine&, const Affine&) = default;

  /// Returns the move by (dx, dy).
  [[nodiscard]] static Affine translation(const Rational& dx, const Rational& dy);
  /// Returns the map that multiplies both coordinates by `factor`.
  [[nodiscard]] static Affine scaling(const Rational& factor);
  /// Returns the counter-clockwise rotation about the origin by 2·atan(half). It is exact: its
  /// cosine is (1 − half²)/(1 + half²), and its sine is 2·half/(1 + half²).
  [[nodiscard]] static Affine rotation(const Rational& half);
  /// Returns the counter-clockwise rotation about the origin by `turns` times 90 degrees.
  [[nodiscard]] static Affine quarter_turns(int turns);
  /// Returns the map that applies `first`, and then this map.
  [[nodiscard]] Affine after(const Affine& first) const;
  /// Returns the image of a point.
  [[nodiscard]] Point operator()(const Point& point) const;
};

/// Returns the image of any geometry. Rings and polylines keep their order of vertices. So the
/// image need not be in canonical form, and its edges have no origins. O(n). Throws Error:
/// kCancelled; kLimitExceeded as Region::add_vertex does.
[[nodiscard]] MINKSUM_API Geometry transform(const Geometry& geometry, const Affine& map,
                                             const Options& options = {});
/// Returns the image of a region, as above.
[[nodiscard]] MINKSUM_API Region transform(const Region& region, const Affine& map,
                                           const Options& options = {});
/// Returns the point mirror { −p | p ∈ geometry }. Complexity and errors are those of `transform`.
[[nodiscard]] MINKSUM_API Geometry reflect(const Geometry& geometry, const Options& options = {});
/// Returns the point mirror of a region, as above.
[[nodiscard]] MINKSUM_API Region reflect(const Region& region, const Options& options = {});

}  // namespace minksum

// Moving, turning, mirroring and scaling, exactly.
#pragma once

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// (x, y) ↦ (xx·x + xy·y + dx, yx·x + yy·y + dy).
struct MINKSUM_API Affine {
  Rational xx = 1;  ///< of x in the new x
  Rational xy;      ///< of y in the new x
  Rational dx;      ///< is added to the new x
  Rational yx;      ///< of x in the new y
  Rational yy = 1;  ///< of y in the new y
  Rational dy;      ///< is added to the new y

  /// A move by (dx, dy).
  [[nodiscard]] static Affine translation(const Rational& dx, const Rational& dy);
  /// All lengths times `factor`, away from the origin.
  [[nodiscard]] static Affine scaling(const Rational& factor);
  /// Counter-clockwise, by the angle whose half has the tangent `half`: an exact turn by
  /// 2·atan(half), with cosine (1 − half²)/(1 + half²) and sine 2·half/(1 + half²).
  [[nodiscard]] static Affine rotation(const Rational& half);
  /// Counter-clockwise, `turns` times 90 degrees.
  [[nodiscard]] static Affine quarter_turns(int turns);
  /// First `first`, then this.
  [[nodiscard]] Affine after(const Affine& first) const;
  /// The image of a point.
  [[nodiscard]] Point operator()(const Point& point) const;
};

/// The geometry's image. Rings and paths keep their order of vertices; the form is not canonical
/// any more, and origins are not kept. O(n). Throws Error(kCancelled).
[[nodiscard]] MINKSUM_API Geometry transform(const Geometry& geometry, const Affine& map,
                                             const Options& options = {});
/// The region's image. As above.
[[nodiscard]] MINKSUM_API Region transform(const Region& region, const Affine& map,
                                           const Options& options = {});
/// The point mirror { −p | p ∈ geometry }. Throws Error(kCancelled).
[[nodiscard]] MINKSUM_API Geometry reflect(const Geometry& geometry, const Options& options = {});
/// The point mirror of a region. As above.
[[nodiscard]] MINKSUM_API Region reflect(const Region& region, const Options& options = {});

}  // namespace minksum

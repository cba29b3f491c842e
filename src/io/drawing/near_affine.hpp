// Declares affine maps of drawings, which may be known up to an error.
#pragma once

#include "io/drawing/curve.hpp"
#include "minksum/transform.hpp"

namespace minksum::io {

/// An affine map near the one that a drawing asks for. Sines of most angles are irrational.
///
/// For a point whose coordinates are at most r, the image's coordinates are off by at most
/// `scale_error`·r + `shift_error`. Both are 0 if the map is exact.
struct NearAffine {
  Affine map;
  double scale_error = 0;
  double shift_error = 0;

  [[nodiscard]] bool is_exact() const { return scale_error == 0 && shift_error == 0; }
  /// Returns the map that applies `first`, and then this one.
  [[nodiscard]] NearAffine after(const NearAffine& first) const;
  /// Returns the image of a vector.
  [[nodiscard]] Span operator()(const Span& vector) const;
  [[nodiscard]] Point operator()(const Point& point) const { return map(point); }
  /// Returns a bound on the error of a point's image.
  [[nodiscard]] double error_at(const Point& point) const;

  /// Returns the counter-clockwise rotation about the origin. Multiples of 90 degrees are exact.
  static NearAffine rotation(const Rational& degrees);
  /// Returns (x, y) ↦ (x + y·tan(degrees), y).
  static NearAffine skew_x(const Rational& degrees);
};

/// Returns the sine and the cosine of an angle in radians.
[[nodiscard]] Span direction_of(const Interval& radians);

}  // namespace minksum::io

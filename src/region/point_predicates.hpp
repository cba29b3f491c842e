// Decides orientation and order of points by doubles with a bound, and exactly where needed.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "minksum/region.hpp"

namespace minksum {

/// Returns a bound on the error of a coordinate's nearest double, for coordinates up to
/// `magnitude`. It is never 0. It is twice the error itself, so that adding it to a double, or
/// subtracting it, may round as well.
inline double rounding_error(double magnitude) { return 0x1p-52 * magnitude + 0x1p-1073; }

/// A point, exactly and in doubles that are off by at most `error`.
struct RoundedPoint {
  Point exact;
  double x;
  double y;
  double error;

  explicit RoundedPoint(Point point)
      : exact(std::move(point)),
        x(exact.x.to_double()),
        y(exact.y.to_double()),
        error(rounding_error(std::max(std::abs(x), std::abs(y)))) {}
  [[nodiscard]] const Rational& exact_x() const { return exact.x; }
  [[nodiscard]] const Rational& exact_y() const { return exact.y; }
};

// Any type `Rounded` below must have such members.

/// Returns the sign of a's coordinate minus b's.
template <class Rounded>
int compare_x(const Rounded& a, const Rounded& b) {
  if (std::abs(a.x - b.x) > 2 * (a.error + b.error)) return a.x < b.x ? -1 : 1;
  return (a.exact_x() - b.exact_x()).sign();
}
template <class Rounded>
int compare_y(const Rounded& a, const Rounded& b) {
  if (std::abs(a.y - b.y) > 2 * (a.error + b.error)) return a.y < b.y ? -1 : 1;
  return (a.exact_y() - b.exact_y()).sign();
}

/// Returns 1 if a, b, c turn left, -1 if they turn right, and 0 if they are in one line.
///
/// Let r be the largest computed difference of coordinates, and e a bound on the error of such a
/// difference. Inexact differences change the determinant by at most 4 r e + 4 e², and its own
/// roundings by at most 2^-51 r². `error` is twice that. `error` also covers underflow, as long as
/// it is far above the smallest doubles. Where anything overflows, nothing is certain.
template <class Rounded>
int turn(const Rounded& a, const Rounded& b, const Rounded& c) {
  constexpr double kFarAboveUnderflow = 0x1p-1000;
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const double r = std::max({std::abs(ux), std::abs(uy), std::abs(vx), std::abs(vy)});
  const double e = 2 * (a.error + b.error + c.error) + 0x1p-52 * r;
  const double error = 8 * e * (r + e) + 0x1p-50 * r * r;
  const double determinant = ux * vy - uy * vx;
  if (error > kFarAboveUnderflow && std::isfinite(error) && std::abs(determinant) > error) {
    return determinant > 0 ? 1 : -1;
  }
  return ((b.exact_x() - a.exact_x()) * (c.exact_y() - a.exact_y()) -
          (b.exact_y() - a.exact_y()) * (c.exact_x() - a.exact_x()))
      .sign();
}

}  // namespace minksum

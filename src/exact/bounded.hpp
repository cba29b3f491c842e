// Defines doubles with a bound on their error: the filter before exact arithmetic.
#pragma once

#include <cmath>

#include "exact/sign.hpp"

namespace minksum {

/// A number that is within `error` of `value`.
///
/// Each operation adds a bound on its own rounding: u·|result| for u = 2^-53, and kTiny for results
/// that underflow. Bounds are computed in doubles, too. The roundings of bounds are factors of at
/// most 1 ± u each, which kInflate covers many times over. Overflow makes the error infinite or no
/// number, and then nothing is certain any more.
struct Bounded {
  double value = 0;
  double error = 0;

  static constexpr double kRounding = 0x1p-52;  ///< 2u: u, and roundings of the bound
  static constexpr double kInflate = 1 + 0x1p-49;
  static constexpr double kTiny = 0x1p-1000;

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double result = a.value + b.value;
    return {result, (a.error + b.error) * kInflate + std::fabs(result) * kRounding};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    const double result = a.value - b.value;
    return {result, (a.error + b.error) * kInflate + std::fabs(result) * kRounding};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const double result = a.value * b.value;
    const double carried =
        std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error;
    return {result, carried * kInflate + std::fabs(result) * kRounding + kTiny};
  }
  /// |A/B − a/b| = |(A − a) − (a/b)·(B − b)| / |B|. The error is infinite if b may be 0.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const double result = a.value / b.value;
    const double least = (std::fabs(b.value) - b.error) / kInflate;
    if (!(least > 0)) return {0, HUGE_VAL};
    const double carried = (a.error + std::fabs(result) * b.error) / least;
    return {result, carried * kInflate + std::fabs(result) * kRounding + kTiny};
  }

  /// Tells whether the sign is certain, and not 0.
  [[nodiscard]] bool certain() const { return std::fabs(value) > error; }
  [[nodiscard]] Sign sign() const { return value > 0 ? kPositive : kNegative; }
};

}  // namespace minksum

// Intervals of doubles that certainly contain the number that they stand for.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "minksum/rational.hpp"

namespace minksum::io {

/// All numbers from `low` to `high`. Each operation rounds outwards, so its result contains every
/// result on members. Zero is exact: products with it and sums with it are not rounded.
struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  Interval(double value) : low(value), high(value) {}  // NOLINT(google-explicit-constructor)
  Interval(double from, double to) : low(from), high(to) {}
  /// Returns an interval around a number that need not be a double.
  static Interval of(const Rational& value) {
    const double near = value.to_double();
    return near == 0 && value.sign() == 0 ? Interval() : widened(near, near);
  }
  /// Returns the interval with its ends rounded outwards.
  static Interval widened(double low, double high) { return {-next_above(-low), next_above(high)}; }
  [[nodiscard]] bool is_zero() const { return low == 0 && high == 0; }
  [[nodiscard]] double middle() const { return low + (high - low) / 2; }

 private:
  /// Returns a number above a finite one, mostly the next one. From Rump, Zimmermann, Boldo and
  /// Melquiond, Computing predecessor and successor in rounding to nearest, BIT 49, 2009.
  static double next_above(double value) {
    constexpr double kUnit = 0x1.0000000000001p-53;
    return value + (std::abs(value) * kUnit + std::numeric_limits<double>::denorm_min());
  }
};

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  return Interval::widened(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }
inline Interval operator*(const Interval& a, const Interval& b) {
  if (a.is_zero() || b.is_zero()) return {};
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return Interval::widened(std::min({p, q, r, s}), std::max({p, q, r, s}));
}
inline double half_of(double a) { return 0.5 * a; }
/// Is exact, but for the smallest numbers.
inline Interval half_of(const Interval& a) {
  const Interval half(half_of(a.low), half_of(a.high));
  return half.low + half.low == a.low && half.high + half.high == a.high
             ? half
             : Interval::widened(half.low, half.high);
}
/// `b` must not contain 0: the quotient is then not finite, and proves nothing.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (a.is_zero()) return {};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(b.low > 0 || b.high < 0)) return {-kInfinity, kInfinity};
  const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
  return Interval::widened(std::min({p, q, r, s}), std::max({p, q, r, s}));
}
/// Takes what is below 0 as 0.
inline Interval square_root(const Interval& a) {
  const Interval root =
      Interval::widened(std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0)));
  return {std::max(root.low, 0.0), a.high <= 0 ? 0 : root.high};
}

}  // namespace minksum::io

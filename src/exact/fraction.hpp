// Declares a rational number whose arithmetic does not look for lowest terms.
#pragma once

#include <utility>

#include "exact/big_integer.hpp"

namespace minksum {

/// The number numerator / denominator; the denominator is positive. Predicates ask for signs alone,
/// by formulas of a few steps. Finding lowest terms after each step would cost far more than the
/// longer numbers do.
class Fraction {
 public:
  Fraction() = default;
  explicit Fraction(BigInteger value) : numerator_(std::move(value)) {}
  /// `denominator` must be positive.
  Fraction(BigInteger numerator, BigInteger denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {}

  [[nodiscard]] const BigInteger& numerator() const { return numerator_; }
  [[nodiscard]] const BigInteger& denominator() const { return denominator_; }
  /// Returns the same number in lowest terms.
  [[nodiscard]] Fraction reduced() const;
  /// Whether the denominator is 1. It may be another one even if the value is an integer.
  [[nodiscard]] bool is_integer() const {
    return denominator_.limb_count() == 1 && denominator_.limb(0) == 1;
  }

  friend Fraction operator+(const Fraction& a, const Fraction& b);
  friend Fraction operator-(const Fraction& a, const Fraction& b);
  friend Fraction operator*(const Fraction& a, const Fraction& b);
  friend Fraction operator/(const Fraction& a, const Fraction& b);
  friend bool operator<(const Fraction& a, const Fraction& b);
  friend Sign sign_of(const Fraction& value) { return sign_of(value.numerator_); }

 private:
  BigInteger numerator_;
  BigInteger denominator_ = 1;
};

/// Returns the double nearest to value · 2^exp2.
inline double to_double(const Fraction& value, int exp2 = 0) {
  return nearest_double(value.numerator(), value.denominator(), exp2);
}

}  // namespace minksum

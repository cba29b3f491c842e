// Defines a rational number whose arithmetic does not look for lowest terms.
#pragma once

#include <cstdint>
#include <utility>

#include "exact/big_integer.hpp"
#include "exact/gcd.hpp"
#include "exact/sign.hpp"

namespace minksum {

/// The number numerator / denominator; the denominator is positive. Predicates ask for signs alone,
/// by formulas of a few steps. Finding lowest terms after each step would cost far more than the
/// longer numbers do.
class Fraction {
 public:
  Fraction() = default;
  explicit Fraction(std::int64_t value) : numerator_(value) {}
  /// `denominator` must be positive.
  Fraction(BigInteger numerator, BigInteger denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {}
  explicit Fraction(const BigRational& value)
      : numerator_(boost::multiprecision::numerator(value)),
        denominator_(boost::multiprecision::denominator(value)) {}

  [[nodiscard]] const BigInteger& numerator() const { return numerator_; }
  [[nodiscard]] const BigInteger& denominator() const { return denominator_; }
  /// Returns the same number in lowest terms.
  [[nodiscard]] Fraction reduced() const {
    const BigInteger common = greatest_common_divisor(numerator_, denominator_);
    return common == 1 ? *this : Fraction(numerator_ / common, denominator_ / common);
  }
  [[nodiscard]] BigRational rational() const { return BigRational(numerator_, denominator_); }

  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    return added(a, b.numerator_, b.denominator_);
  }
  friend Fraction operator-(const Fraction& a, const Fraction& b) {
    return added(a, -b.numerator_, b.denominator_);
  }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
  }
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    Fraction result{a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
    if (b.numerator_ < 0) {
      result.numerator_ = -result.numerator_;
      result.denominator_ = -result.denominator_;
    }
    return result;
  }
  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.numerator_ * b.denominator_ < b.numerator_ * a.denominator_;
  }
  friend Sign sign_of(const Fraction& value) { return static_cast<Sign>(value.numerator_.sign()); }

 private:
  static Fraction added(const Fraction& a, const BigInteger& numerator,
                        const BigInteger& denominator) {
    if (a.denominator_ == denominator) return {a.numerator_ + numerator, denominator};
    return {a.numerator_ * denominator + numerator * a.denominator_, a.denominator_ * denominator};
  }

  BigInteger numerator_ = 0;
  BigInteger denominator_ = 1;
};

/// Returns the double nearest to value · 2^exp2.
inline double to_double(const Fraction& value, int exp2 = 0) {
  return nearest_double(value.numerator() < 0, BigInt(abs(value.numerator())),
                        BigInt(value.denominator()), exp2);
}

}  // namespace minksum

#include "exact/fraction.hpp"

#include "exact/gcd.hpp"

namespace minksum {

Fraction Fraction::reduced() const {
  if (is_integer()) return *this;
  const BigInteger common = greatest_common_divisor(numerator_, denominator_);
  return common == 1 ? *this : Fraction(numerator_ / common, denominator_ / common);
}

Fraction operator+(const Fraction& a, const Fraction& b) {
  if (a.denominator_ == b.denominator_) return {a.numerator_ + b.numerator_, a.denominator_};
  return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}
Fraction operator-(const Fraction& a, const Fraction& b) {
  if (a.denominator_ == b.denominator_) return {a.numerator_ - b.numerator_, a.denominator_};
  return {a.numerator_ * b.denominator_ - b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}
Fraction operator*(const Fraction& a, const Fraction& b) {
  if (a.is_integer()) return {a.numerator_ * b.numerator_, b.denominator_};
  if (b.is_integer()) return {a.numerator_ * b.numerator_, a.denominator_};
  return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
}
Fraction operator/(const Fraction& a, const Fraction& b) {
  const bool negative = b.numerator_.sign() < 0;
  return {a.numerator_ * (negative ? -b.denominator_ : b.denominator_),
          a.denominator_ * abs(b.numerator_)};
}
bool operator<(const Fraction& a, const Fraction& b) {
  if (a.denominator_ == b.denominator_) return a.numerator_ < b.numerator_;
  return a.numerator_ * b.denominator_ < b.numerator_ * a.denominator_;
}

}  // namespace minksum

// The inside of Rational for the library's own code: numerator and denominator as big integers.
#pragma once

#include <memory>

#include "exact/big_integer.hpp"
#include "minksum/rational.hpp"

namespace minksum {

/// Always in lowest terms, denominator positive, numerator not zero (zero is the null pointer).
struct Rational::Value {
  BigInt numerator;
  BigInt denominator;
};

class RationalAccess {
 public:
  /// numerator / denominator, brought to lowest terms; the denominator must not be zero.
  static Rational make(BigInt numerator, BigInt denominator);
  /// The same for a quotient known to be in lowest terms with a positive denominator.
  static Rational make_reduced(BigInt numerator, BigInt denominator);
  static const BigInt& numerator(const Rational& value);
  static const BigInt& denominator(const Rational& value);
};

}  // namespace minksum

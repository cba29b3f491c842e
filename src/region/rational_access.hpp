// Gives the library's own code the inside of Rational: numerator and denominator as big integers.
#pragma once

#include <memory>

#include "exact/big_integer.hpp"
#include "minksum/rational.hpp"

namespace minksum {

/// A quotient in lowest terms; the denominator is positive. The numerator is not zero, because zero
/// is the null pointer.
struct Rational::Value {
  BigInt numerator;
  BigInt denominator;
};

class RationalAccess {
 public:
  /// Returns numerator / denominator in lowest terms. The denominator must not be zero.
  static Rational make(BigInt numerator, BigInt denominator);
  /// Does the same for a quotient known to be in lowest terms with a positive denominator.
  static Rational make_reduced(BigInt numerator, BigInt denominator);
  static const BigInt& numerator(const Rational& value);
  static const BigInt& denominator(const Rational& value);
};

}  // namespace minksum

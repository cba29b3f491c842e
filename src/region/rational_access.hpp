// Gives the library's own code the inside of Rational: numerator and denominator as big integers.
#pragma once

#include <memory>

#include "exact/big_integer.hpp"
#include "minksum/rational.hpp"

namespace minksum {

/// A quotient in lowest terms; the denominator is positive. The numerator is not zero, because zero
/// is the null pointer.
struct Rational::Value {
  BigInteger numerator;
  BigInteger denominator;
};

class RationalAccess {
 public:
  /// Returns numerator / denominator in lowest terms. The denominator must not be zero.
  static Rational make(BigInteger numerator, BigInteger denominator);
  /// Returns numerator / denominator · 2^exp2 · 10^exp10, likewise.
  static Rational make(BigInteger numerator, BigInteger denominator, int exp2, int exp10);
  /// Does the same for a quotient known to be in lowest terms with a positive denominator.
  static Rational make_reduced(BigInteger numerator, BigInteger denominator);
  static const BigInteger& numerator(const Rational& value);
  static const BigInteger& denominator(const Rational& value);
};

}  // namespace minksum

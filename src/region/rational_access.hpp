// The inside of Rational for the library's own code: numerator and denominator as big integers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "minksum/rational.hpp"

namespace minksum {

using BigInt = boost::multiprecision::cpp_int;

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

/// Bits of |value|: 0 for 0.
[[nodiscard]] std::size_t bit_length(const BigInt& value);
[[nodiscard]] BigInt power_of_ten(unsigned exponent);
[[nodiscard]] BigInt from_limbs(std::span<const std::uint64_t> limbs);
/// Appends |value| as little-endian 64-bit limbs without leading zeros; returns how many.
std::size_t append_limbs(const BigInt& value, std::vector<std::uint64_t>& limbs);

/// The double nearest to ±numerator / denominator · 2^exp2 (ties to even; denormals and overflow
/// to infinity as IEEE 754 has them; zero is +0). numerator >= 0, denominator > 0.
[[nodiscard]] double nearest_double(bool negative, const BigInt& numerator,
                                    const BigInt& denominator, std::int64_t exp2 = 0);

}  // namespace minksum

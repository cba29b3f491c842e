// The greatest common divisor of long integers.
#pragma once

#include "exact/big_integer.hpp"

namespace minksum {

/// The greatest common divisor of |a| and |b|; 0 if both are 0.
///
/// Boost's function passes over all words of both numbers for every few bits. Here the leading bits
/// decide many steps of Euclid's algorithm, and one pass over the words applies all these steps.
/// That is Lehmer's method, with the condition of Knuth 1997, section 4.5.2, algorithm L. O(n²) for
/// n words.
[[nodiscard]] BigInteger greatest_common_divisor(const BigInteger& a, const BigInteger& b);
/// The least common multiple of positive integers.
[[nodiscard]] inline BigInteger least_common_multiple(const BigInteger& a, const BigInteger& b) {
  return a == b ? a : a / greatest_common_divisor(a, b) * b;
}

}  // namespace minksum

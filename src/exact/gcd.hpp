// The greatest common divisor of long integers.
#pragma once

#include "exact/big_integer.hpp"

namespace minksum {

/// The greatest common divisor of |a| and |b|; 0 if both are 0.
///
/// Boost subtracts and divides one step at a time. This takes the steps of many words at once from
/// the leading bits: Lehmer's method, with the condition of Knuth 1997, section 4.5.2, algorithm L.
/// O(n²) for n words, with 64 n² / 30 or so multiplications of words of 32 bits.
[[nodiscard]] BigInt greatest_common_divisor(const BigInt& a, const BigInt& b);
[[nodiscard]] BigInteger greatest_common_divisor(const BigInteger& a, const BigInteger& b);

}  // namespace minksum

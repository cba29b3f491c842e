// Declares integers and rationals of any size, from Boost.Multiprecision.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace minksum {

using BigInt = boost::multiprecision::cpp_int;
// These types have no expression templates, so results of arithmetic have the type that the
// formulas name.
using BigInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                             boost::multiprecision::et_off>;
using BigRational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                                  boost::multiprecision::et_off>;

/// Returns the count of bits of |value|, which is 0 for 0.
[[nodiscard]] std::size_t bit_length(const BigInt& value);
[[nodiscard]] BigInt power_of_ten(unsigned exponent);
[[nodiscard]] BigInt from_limbs(std::span<const std::uint64_t> limbs);
/// Appends |value| as little-endian 64-bit limbs without leading zeros, and returns their count.
std::size_t append_limbs(const BigInt& value, std::vector<std::uint64_t>& limbs);

/// Returns the double nearest to ±numerator / denominator · 2^exp2, for numerator >= 0 and
/// denominator > 0. Ties go to even. Denormals, and overflow to infinity, are as in IEEE 754; zero
/// is +0.
[[nodiscard]] double nearest_double(bool negative, const BigInt& numerator,
                                    const BigInt& denominator, std::int64_t exp2 = 0);

}  // namespace minksum

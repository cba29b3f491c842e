// Defines the number types of the signed method: one set for each size of coordinates.
//
// All coordinates are non-negative integers below 2^B. Both operands are scaled to integers and
// moved so that their boxes start at 0. Then the box of their sum starts at 0, too. These bounds
// hold:
//
//   | quantity                                     | bound            | type       |
//   | coordinate of a vertex of the convolution    | 0 <= c < 2^B     | Coordinate |
//   | cross product of two differences             | |c| < 2^(2B+1)   | Product    |
//   | denominator d of a crossing                  | 0 < d < 2^(2B+1) | Product    |
//   | numerators of a crossing, c·d + t·(c' - c)   | 0 <= n < 2^(3B+2)| Scaled     |
//   | a numerator times 2^(kKeyBits - B) (its key) | < 2^(2B+64)      | Scaled     |
//   | side of a crossing against a segment         | < 2^(4B+3)       | Comparison |
//   | order of two crossings, n·d' against n'·d    | < 2^(5B+3)       | Comparison |
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace minksum::signed_sum {

/// Integers of any size, without expression templates, so that `auto` and `?:` mean what they say.
using BigInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                 boost::multiprecision::et_off>;
__extension__ typedef __int128 Int128;
using Int256 = boost::multiprecision::int256_t;
using Int512 = boost::multiprecision::int512_t;

/// Keys decide the order of points first. A key is floor(c · 2^(kKeyBits - B)), a monotone function
/// of the exact coordinate. So unequal keys tell the order, and equal points have equal keys.
inline constexpr unsigned kKeyBits = 62;

struct NarrowNumbers {
  using Coordinate = std::int64_t;
  using Product = std::int64_t;
  using Scaled = Int128;
  using Comparison = Int256;
  static constexpr unsigned kBits = 30;
  static_assert(2 * kBits + 1 <= 63 && 3 * kBits + 2 <= 127 && 2 * kBits + 64 <= 127);
  static_assert(5 * kBits + 3 <= 256);
};

struct MediumNumbers {
  using Coordinate = std::int64_t;
  using Product = Int128;
  using Scaled = Int256;
  using Comparison = Int512;
  static constexpr unsigned kBits = 60;
  static_assert(2 * kBits + 1 <= 127 && 3 * kBits + 2 <= 256 && 2 * kBits + 64 <= 256);
  static_assert(5 * kBits + 3 <= 512);
};

struct ArbitraryNumbers {
  using Coordinate = BigInteger;
  using Product = BigInteger;
  using Scaled = BigInteger;
  using Comparison = BigInteger;
};

/// Returns the same value in a type at least as wide. Boost's integers take 128 bits in two parts.
template <class To, class From>
[[nodiscard]] To widen(const From& value) {
  if constexpr (std::is_same_v<To, From>) {
    return value;
  } else if constexpr (std::is_same_v<From, Int128> && std::is_class_v<To>) {
    To result(static_cast<std::int64_t>(value >> 64));
    result *= To(std::uint64_t{1} << 32) * To(std::uint64_t{1} << 32);
    result += To(static_cast<std::uint64_t>(value));
    return result;
  } else {
    return static_cast<To>(value);
  }
}

template <class Number>
[[nodiscard]] int sign_of(const Number& value) {
  return value < 0 ? -1 : value > 0 ? 1 : 0;
}

}  // namespace minksum::signed_sum

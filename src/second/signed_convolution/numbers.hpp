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

#include <cstdint>

#include "exact/big_integer.hpp"
#include "exact/wide_int.hpp"

namespace minksum::signed_sum {

/// Keys decide the order of points first. A key is floor(c · 2^(kKeyBits - B)), a monotone function
/// of the exact coordinate. So unequal keys tell the order, and equal points have equal keys.
inline constexpr unsigned kKeyBits = 62;

struct NarrowNumbers {
  using Coordinate = std::int64_t;
  using Product = std::int64_t;
  using Scaled = Int128;
  using Comparison = WideInt<3>;
  static constexpr unsigned kBits = 30;
  static_assert(2 * kBits + 1 <= 63 && 3 * kBits + 2 <= 127 && 2 * kBits + 64 <= 127);
  static_assert(5 * kBits + 3 < Comparison::kBits);
};

struct MediumNumbers {
  using Coordinate = std::int64_t;
  using Product = Int128;
  using Scaled = WideInt<3>;
  using Comparison = WideInt<5>;
  static constexpr unsigned kBits = 60;
  static_assert(2 * kBits + 1 <= 127);
  static_assert(3 * kBits + 2 < Scaled::kBits && 2 * kBits + 64 < Scaled::kBits);
  static_assert(5 * kBits + 3 < Comparison::kBits);
};

struct ArbitraryNumbers {
  using Coordinate = BigInteger;
  using Product = BigInteger;
  using Scaled = BigInteger;
  using Comparison = BigInteger;
};

}  // namespace minksum::signed_sum

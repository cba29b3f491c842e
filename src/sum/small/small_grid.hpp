// Brings coordinates of small operands to the grid of a smaller step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"
#include "sum/small/small_vectors.hpp"

namespace minksum {

/// The largest offset and coordinate: sums of two offsets and two coordinates fit in 64 bits.
inline constexpr std::int64_t kFarthest = std::int64_t{1} << 60;
/// The bits of those of a wide operand, and of a long one.
inline constexpr int kFarthestBits = 125;
inline constexpr int kFarthestLongBits = 250;

inline constexpr int kMostTwos = 60;  // a higher power of two is beyond the largest offset, too
/// Multiplies by 10^tens · 2^twos. Returns false if the product is too large for an offset.
inline bool scale(int tens, int twos, std::int64_t& value) {
  if ((tens | twos) == 0) return -kFarthest <= value && value <= kFarthest;
  if (tens >= static_cast<int>(kPowersOfTen.size()) || twos > kMostTwos) return value == 0;
  return !__builtin_mul_overflow(value, kPowersOfTen[static_cast<std::size_t>(tens)], &value) &&
         !__builtin_mul_overflow(value, std::int64_t{1} << twos, &value) && -kFarthest <= value &&
         value <= kFarthest;
}
[[gnu::noinline]] inline bool scale(int tens, int twos, Int128& value) {
  if (value == 0) return true;
  if (bit_width(value) + bits_of_ten_to(tens) + twos > kFarthestBits) return false;
  value = scaled(value, twos, tens);
  return true;
}

inline bool scale(int tens, int twos, WideNumber& value) {
  if (value == WideNumber(0)) return true;
  if (bit_width(value) + bits_of_ten_to(tens) + twos > kFarthestLongBits) return false;
  constexpr int kFewTens = 18;
  for (; tens > 0; tens -= kFewTens) {
    value = product<WideNumber>(value,
                                kPowersOfTen[static_cast<std::size_t>(std::min(tens, kFewTens))]);
  }
  for (; twos > 0; twos -= kMostTwos) {
    value = product<WideNumber>(value, std::int64_t{1} << std::min(twos, kMostTwos));
  }
  return true;
}

/// Returns an integer vector, with relative errors under 2^-52.
template <class Integer>
[[nodiscard]] Vec<double> rounded(const Vec<Integer>& v) {
  return {to_near_double(v.x), to_near_double(v.y)};
}

}  // namespace minksum

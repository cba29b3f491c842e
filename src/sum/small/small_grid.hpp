// Brings coordinates of small operands to the grid of a smaller step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/formulas.hpp"
#include "exact/wide_int.hpp"

namespace minksum {

/// The largest offset and coordinate: sums of two offsets and two coordinates fit in 64 bits.
inline constexpr std::int64_t kFarthest = std::int64_t{1} << 60;
/// The bits of those of a wide operand.
inline constexpr int kFarthestBits = 125;

inline constexpr int kMostTwos = 60;  // a higher power of two is beyond the largest offset, too
inline constexpr auto kPowersOfTen = [] {
  std::array<std::int64_t, 19> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}();
/// Multiplies by 10^tens · 2^twos. Returns false if the product is too large for an offset.
inline bool scale(int tens, int twos, std::int64_t& value) {
  if ((tens | twos) == 0) return -kFarthest <= value && value <= kFarthest;
  if (tens >= static_cast<int>(kPowersOfTen.size()) || twos > kMostTwos) return value == 0;
  return !__builtin_mul_overflow(value, kPowersOfTen[static_cast<std::size_t>(tens)], &value) &&
         !__builtin_mul_overflow(value, std::int64_t{1} << twos, &value) && -kFarthest <= value &&
         value <= kFarthest;
}
inline bool scale(int tens, int twos, Int128& value) {
  if (value == 0) return true;
  if (bit_width(value) + bits_of_ten_to(tens) + twos > kFarthestBits) return false;
  constexpr int kFewTens = 18;
  for (; tens > kFewTens; tens -= kFewTens) value *= kPowersOfTen[kFewTens];
  value *= kPowersOfTen[static_cast<std::size_t>(tens)] * (Int128{1} << twos);
  return true;
}

/// Returns an integer vector rounded to doubles.
[[nodiscard]] inline Vec<double> rounded(const Vec<Int128>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

}  // namespace minksum

// Pseudo-random numbers that are always the same.
#pragma once

#include <cstdint>

namespace minksum {

/// Returns 32 bits that look random, even for values of `i` in order. The factors are two of
/// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
[[nodiscard]] constexpr std::uint32_t scramble(std::uint64_t i) {
  const std::uint64_t h = i * 0x9E3779B97F4A7C15U;
  return static_cast<std::uint32_t>((h ^ h >> 29) * 0xBF58476D1CE4E5B9U >> 32);
}

}  // namespace minksum

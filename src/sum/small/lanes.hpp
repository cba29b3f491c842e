// Arrays that are read eight numbers at a time, and sets of few things.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace minksum {

inline constexpr std::size_t kLanes = 8;
/// Returns how many entries an array of `size` has if it is read eight at a time.
[[nodiscard]] constexpr std::size_t filled_up(std::size_t size) {
  return (size + kLanes - 1) / kLanes * kLanes;
}

/// A set of up to 64 things.
using LaneBits = std::uint64_t;

alignas(64) inline constexpr auto kBitOf = [] {
  std::array<LaneBits, 64> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = LaneBits{1} << i;
  return bits;
}();
/// Where each of eight bytes begins.
alignas(64) inline constexpr std::array<LaneBits, kLanes> kByteOf{0, 8, 16, 24, 32, 40, 48, 56};
[[nodiscard]] constexpr LaneBits first_bits(std::size_t count) {
  return count >= 64 ? ~LaneBits{0} : (LaneBits{1} << count) - 1;
}
template <class Visit>
[[gnu::always_inline]] inline void for_each_bit(LaneBits bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

/// Exchanges rows and columns of eight by eight bits.
[[nodiscard]] constexpr LaneBits transposed(LaneBits bits) {
  const auto exchange = [&](int shift, LaneBits mask) {
    const LaneBits changed = (bits ^ (bits >> shift)) & mask;
    bits ^= changed ^ (changed << shift);
  };
  exchange(7, 0x00AA00AA00AA00AA);
  exchange(14, 0x0000CCCC0000CCCC);
  exchange(28, 0x00000000F0F0F0F0);
  return bits;
}

}  // namespace minksum

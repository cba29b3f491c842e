#include "exact/gcd.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace minksum {
namespace {

/// The words of a number, the lowest first. The last one is not 0.
using Words = std::vector<std::uint32_t>;

constexpr unsigned kWordBits = 32;

void trim(Words& words) {
  while (!words.empty() && words.back() == 0) words.pop_back();
}

Words words_of(const BigInteger& value) {
  Words words(2 * value.limb_count());
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = static_cast<std::uint32_t>(value.limb(i / 2) >> (i % 2 * kWordBits));
  }
  trim(words);
  return words;
}

BigInteger value_of(const Words& words) {
  std::vector<std::uint64_t> limbs((words.size() + 1) / 2);
  for (std::size_t i = 0; i < words.size(); ++i) {
    limbs[i / 2] |= std::uint64_t{words[i]} << (i % 2 * kWordBits);
  }
  return BigInteger(limbs);
}

bool is_less(const Words& a, const Words& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

/// The linear map (a, b) ↦ (aa·a + ab·b, ba·a + bb·b) of some steps of Euclid's algorithm.
struct Steps {
  std::int64_t aa = 1;
  std::int64_t ab = 0;
  std::int64_t ba = 0;
  std::int64_t bb = 1;
};

/// Returns 62 bits of a number. The first one is bit `top` of word `size`, both counted from 1. So
/// two numbers are cut at the same place.
std::int64_t leading_bits(const Words& words, std::size_t size, int top) {
  const auto at = [&](std::size_t i) -> std::uint64_t { return i < words.size() ? words[i] : 0; };
  // Three words hold 62 bits wherever they begin; `top` is the width of the highest one.
  const std::uint64_t high = at(size - 1) << kWordBits | at(size - 2);
  const std::uint64_t low = size > 2 ? at(size - 3) : 0;
  const int missing = static_cast<int>(kWordBits) - top;
  const std::uint64_t all = missing == 0 ? high : high << missing | low >> top;
  return static_cast<std::int64_t>(all >> 2);
}

/// Returns as many steps as the leading bits of a ≥ b decide for certain.
Steps steps_of(std::int64_t a, std::int64_t b) {
  // A coefficient below this, times a word, is within a signed word of double length.
  constexpr std::int64_t kLargest = std::int64_t{1} << 30;
  Steps s;
  while (b + s.ba != 0 && b + s.bb != 0) {
    const std::int64_t quotient = (a + s.aa) / (b + s.ba);
    if (quotient != (a + s.ab) / (b + s.bb) || quotient > kLargest) break;
    const std::int64_t next_a = s.aa - quotient * s.ba;
    const std::int64_t next_b = s.ab - quotient * s.bb;
    if (next_a > kLargest || next_a < -kLargest || next_b > kLargest || next_b < -kLargest) break;
    s = {s.ba, s.bb, next_a, next_b};
    a = std::exchange(b, a - quotient * b);
  }
  return s;
}

/// Replaces two numbers by what the steps make of them; neither becomes negative.
void apply(const Steps& s, Words& a, Words& b) {
  b.resize(a.size());
  std::int64_t carry_a = 0;
  std::int64_t carry_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto x = static_cast<std::int64_t>(a[i]);
    const auto y = static_cast<std::int64_t>(b[i]);
    carry_a += s.aa * x + s.ab * y;
    carry_b += s.ba * x + s.bb * y;
    a[i] = static_cast<std::uint32_t>(carry_a);
    b[i] = static_cast<std::uint32_t>(carry_b);
    carry_a >>= kWordBits;
    carry_b >>= kWordBits;
  }
  trim(a);
  trim(b);
}

std::uint64_t short_value(const Words& words) {
  std::uint64_t value = 0;
  for (std::size_t i = words.size(); i > 0; --i) value = value << kWordBits | words[i - 1];
  return value;
}

bool is_short(const BigInteger& value) { return value.limb_count() <= 2; }

/// Returns a·x + b·y, which the type must hold, though products may wrap.
Uint128 combined(std::int64_t a, Uint128 x, std::int64_t b, Uint128 y) {
  return static_cast<Uint128>(a) * x + static_cast<Uint128>(b) * y;
}

/// Returns the greatest common divisor of two numbers, neither of which is 0.
BigInteger short_divisor(Uint128 a, Uint128 b) {
  if (a < b) std::swap(a, b);
  while ((a >> 64) != 0 && b != 0) {
    // The 62 highest bits of a, and those of b at the same places.
    const int drop = 66 - std::countl_zero(static_cast<std::uint64_t>(a >> 64));
    const Steps steps =
        steps_of(static_cast<std::int64_t>(a >> drop), static_cast<std::int64_t>(b >> drop));
    if (steps.ab == 0) {
      a = std::exchange(b, a % b);
    } else {
      const Uint128 next = combined(steps.ba, a, steps.bb, b);
      a = combined(steps.aa, a, steps.ab, b);
      b = next;
    }
  }
  if (b == 0) {
    const std::uint64_t limbs[] = {static_cast<std::uint64_t>(a),
                                   static_cast<std::uint64_t>(a >> 64)};
    return BigInteger(limbs);
  }
  // b does not exceed a, which has one limb now.
  return std::gcd(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b));
}

}  // namespace

BigInteger greatest_common_divisor(const BigInteger& a, const BigInteger& b) {
  if (a.is_zero() || b.is_zero()) return abs(a.is_zero() ? b : a);
  if (is_short(a) && is_short(b)) return short_divisor(short_magnitude(a), short_magnitude(b));
  if (is_short(a)) return greatest_common_divisor(a, b % a);
  if (is_short(b)) return greatest_common_divisor(a % b, b);
  Words x = words_of(a);
  Words y = words_of(b);
  if (x.size() < y.size()) std::swap(x, y);
  while (x.size() > 2) {
    if (y.empty()) return value_of(x);
    const auto top = static_cast<int>(std::bit_width(x.back()));
    const bool comparable = y.size() + 1 >= x.size() && is_less(y, x);
    const Steps steps =
        comparable ? steps_of(leading_bits(x, x.size(), top), leading_bits(y, x.size(), top))
                   : Steps{};
    if (steps.ab != 0) {
      apply(steps, x, y);
    } else {
      Words rest = words_of(value_of(x) % value_of(y));
      x = std::exchange(y, std::move(rest));
    }
  }
  return std::gcd(short_value(x), short_value(y));
}

}  // namespace minksum

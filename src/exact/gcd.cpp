#include "exact/gcd.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace minksum {
namespace {

namespace mp = boost::multiprecision;

/// The words of a number, the lowest first, none of the highest 0.
using Words = std::vector<std::uint32_t>;

constexpr unsigned kWordBits = 32;
// Numbers of up to two limbs stay with Boost, which has a way of its own for them.
constexpr std::size_t kFewBytes = 16;

void trim(Words& words) {
  while (!words.empty() && words.back() == 0) words.pop_back();
}

template <class Number>
Words words_of(const Number& value) {
  Words words;
  mp::export_bits(value, std::back_inserter(words), kWordBits, false);
  trim(words);
  return words;
}

template <class Number>
Number value_of(const Words& words) {
  Number value;
  if (!words.empty()) mp::import_bits(value, words.begin(), words.end(), kWordBits, false);
  return value;
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

/// The bits from the top one of `words` down, 62 of them; `shorter`, which is not larger, is cut at
/// the same place.
std::int64_t leading_bits(const Words& words, std::size_t size, int top) {
  const auto at = [&](std::size_t i) -> std::uint64_t { return i < words.size() ? words[i] : 0; };
  // Three words hold 62 bits wherever they begin; `top` is the width of the highest one.
  const std::uint64_t high = at(size - 1) << kWordBits | at(size - 2);
  const std::uint64_t low = size > 2 ? at(size - 3) : 0;
  const int missing = static_cast<int>(kWordBits) - top;
  const std::uint64_t all = missing == 0 ? high : high << missing | low >> top;
  return static_cast<std::int64_t>(all >> 2);
}

/// As many steps as the leading bits of a ≥ b decide for certain.
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

/// Both numbers after the steps; neither becomes negative.
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

template <class Number>
bool is_short(const Number& value) {
  return value.backend().size() * sizeof(*value.backend().limbs()) <= kFewBytes;
}

template <class Number>
Number common_divisor(const Number& a, const Number& b) {
  if (is_short(a) || is_short(b)) return mp::gcd(a, b);
  Words x = words_of(Number(mp::abs(a)));
  Words y = words_of(Number(mp::abs(b)));
  if (x.size() < y.size()) std::swap(x, y);
  while (x.size() > 2) {
    if (y.empty()) return value_of<Number>(x);
    const int top = std::bit_width(x.back());
    const bool comparable = y.size() + 1 >= x.size() && is_less(y, x);
    const Steps steps =
        comparable ? steps_of(leading_bits(x, x.size(), top), leading_bits(y, x.size(), top))
                   : Steps{};
    if (steps.ab != 0) {
      apply(steps, x, y);
    } else {
      Words rest = words_of(Number(value_of<Number>(x) % value_of<Number>(y)));
      x = std::exchange(y, std::move(rest));
    }
  }
  return Number(std::gcd(short_value(x), short_value(y)));
}

}  // namespace

BigInt greatest_common_divisor(const BigInt& a, const BigInt& b) { return common_divisor(a, b); }
BigInteger greatest_common_divisor(const BigInteger& a, const BigInteger& b) {
  return common_divisor(a, b);
}

}  // namespace minksum

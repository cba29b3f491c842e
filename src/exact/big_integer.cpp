// Implements helpers on big integers, and the one correctly rounding division.
#include "exact/big_integer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>

#include "exact/wide_int.hpp"

namespace minksum {

namespace mp = boost::multiprecision;

std::size_t bit_length(const BigInt& value) {
  if (value.is_zero()) return 0;
  const auto& backend = value.backend();
  const mp::limb_type top = backend.limbs()[backend.size() - 1];
  constexpr auto kLimbBits = static_cast<std::size_t>(std::numeric_limits<mp::limb_type>::digits);
  return kLimbBits * backend.size() - static_cast<std::size_t>(std::countl_zero(top));
}

BigInt power_of_ten(unsigned exponent) { return mp::pow(BigInt(10), exponent); }

BigInt from_limbs(std::span<const std::uint64_t> limbs) {
  BigInt value;
  if (limbs.empty()) return value;
  if constexpr (sizeof(mp::limb_type) == sizeof(std::uint64_t)) {
    auto& backend = value.backend();
    const auto size = static_cast<unsigned>(limbs.size());
    backend.resize(size, size);
    std::memcpy(backend.limbs(), limbs.data(), limbs.size_bytes());
    backend.normalize();
  } else {
    mp::import_bits(value, limbs.begin(), limbs.end(), 64, false);
  }
  return value;
}

std::size_t append_limbs(const BigInt& value, std::vector<std::uint64_t>& limbs) {
  if (value.is_zero()) return 0;
  const std::size_t before = limbs.size();
  mp::export_bits(value, std::back_inserter(limbs), 64, false);
  while (limbs.size() > before && limbs.back() == 0) limbs.pop_back();
  return limbs.size() - before;
}

namespace {

// Rounds (bits + r) · 2^exponent, where r is 0, or lies in (0, 1) if `sticky`. The width of `bits`
// must be in [55, 64].
double round_to_double(std::uint64_t bits, bool sticky, std::int64_t exponent) {
  constexpr std::int64_t kPrecision = std::numeric_limits<double>::digits;
  constexpr std::int64_t kLowestExponent = std::numeric_limits<double>::min_exponent - kPrecision;
  const int width = 64 - std::countl_zero(bits);
  // The last place kept is the 53rd bit, or the place of the smallest denormal if that is higher.
  const std::int64_t last_place = std::max(exponent + width - kPrecision, kLowestExponent);
  const std::int64_t drop = last_place - exponent;
  if (drop > width) return 0;  // below half of the smallest denormal
  std::uint64_t kept = drop == 64 ? 0 : bits >> drop;
  const std::uint64_t half = std::uint64_t{1} << (drop - 1);
  const std::uint64_t rest = bits & (half | (half - 1));
  const bool up = rest > half || (rest == half && (sticky || (kept & 1) != 0));
  if (up) ++kept;
  if (last_place > std::numeric_limits<double>::max_exponent) {
    return std::numeric_limits<double>::infinity();
  }
  return std::ldexp(static_cast<double>(kept), static_cast<int>(last_place));
}

// The value must have at most 128 bits.
Uint128 as_short(const BigInt& value) {
  constexpr int kLimbBits = std::numeric_limits<mp::limb_type>::digits;
  const auto& backend = value.backend();
  Uint128 result = 0;
  for (unsigned i = backend.size(); i-- > 0;) result = (result << kLimbBits) | backend.limbs()[i];
  return result;
}

int width_of(Uint128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  return high != 0 ? 128 - std::countl_zero(high)
                   : 64 - std::countl_zero(static_cast<std::uint64_t>(value));
}

// Does what nearest_double does, for a numerator of up to 128 bits and a denominator of up to 64.
double nearest_to_short(Uint128 numerator, Uint128 denominator, std::int64_t exp2) {
  const int shift = 63 - (width_of(numerator) - width_of(denominator));
  (shift >= 0 ? numerator : denominator) <<= std::abs(shift);
  const Uint128 quotient = numerator / denominator;
  return round_to_double(static_cast<std::uint64_t>(quotient), quotient * denominator != numerator,
                         exp2 - shift);
}

}  // namespace

double nearest_double(bool negative, const BigInt& numerator, const BigInt& denominator,
                      std::int64_t exp2) {
  if (numerator.is_zero()) return 0;
  const auto excess = static_cast<std::int64_t>(bit_length(numerator)) -
                      static_cast<std::int64_t>(bit_length(denominator));
  if (excess + exp2 < -1100) return 0;
  double magnitude = std::numeric_limits<double>::infinity();
  if (excess + exp2 <= 1100 && bit_length(numerator) <= 128 && bit_length(denominator) <= 64) {
    magnitude = nearest_to_short(as_short(numerator), as_short(denominator), exp2);
  } else if (excess + exp2 <= 1100) {
    // numerator · 2^shift / denominator lies in (2^62, 2^64), so the quotient has enough bits and
    // fits one limb.
    const std::int64_t shift = 63 - excess;
    BigInt quotient;
    BigInt remainder;
    if (shift >= 0) {
      const BigInt scaled = numerator << static_cast<unsigned long long>(shift);
      mp::divide_qr(scaled, denominator, quotient, remainder);
    } else {
      const BigInt scaled = denominator << static_cast<unsigned long long>(-shift);
      mp::divide_qr(numerator, scaled, quotient, remainder);
    }
    magnitude =
        round_to_double(static_cast<std::uint64_t>(quotient), !remainder.is_zero(), exp2 - shift);
  }
  if (magnitude == 0) return 0;
  return negative ? -magnitude : magnitude;
}

}  // namespace minksum

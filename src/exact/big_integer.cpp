// Implements helpers on big integers, and the one correctly rounding division.
#include "exact/big_integer.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace minksum {

namespace mp = boost::multiprecision;

struct BoostInteger {
  // Without expression templates, so results of arithmetic have the type that the formulas name.
  using Number = mp::number<mp::cpp_int_backend<>, mp::et_off>;
  static_assert(sizeof(Number) <= sizeof(BigInteger) && alignof(Number) <= alignof(BigInteger));
  static_assert(sizeof(mp::limb_type) == sizeof(std::uint64_t));

  static Number& of(BigInteger& value) {
    return *std::launder(reinterpret_cast<Number*>(value.storage_));
  }
  static const Number& of(const BigInteger& value) {
    return *std::launder(reinterpret_cast<const Number*>(value.storage_));
  }
  template <class... Arguments>
  static void make(BigInteger& value, Arguments&&... arguments) {
    ::new (static_cast<void*>(value.storage_)) Number(std::forward<Arguments>(arguments)...);
  }
  static BigInteger made(Number number) {
    BigInteger value{BigInteger::NotMade{}};
    make(value, std::move(number));
    return value;
  }
};

namespace {

auto& number(BigInteger& value) { return BoostInteger::of(value); }
const auto& number(const BigInteger& value) { return BoostInteger::of(value); }
constexpr auto made = BoostInteger::made;

}  // namespace

BigInteger::BigInteger(Int128 value) { BoostInteger::make(*this, value); }
BigInteger::BigInteger(std::span<const std::uint64_t> limbs, bool negative) {
  BoostInteger::make(*this);
  if (limbs.empty()) return;
  auto& backend = number(*this).backend();
  const auto size = static_cast<unsigned>(limbs.size());
  backend.resize(size, size);
  std::memcpy(backend.limbs(), limbs.data(), limbs.size_bytes());
  backend.normalize();
  if (negative) backend.negate();
}
BigInteger::BigInteger(std::string_view digits) {
  // Leading zeros are dropped, because Boost takes them as a mark of octal.
  const std::size_t first = digits.find_first_not_of('0');
  const bool is_zero = first == std::string_view::npos;
  BoostInteger::make(*this, is_zero ? std::string("0") : std::string(digits.substr(first)));
}
BigInteger::BigInteger(const BigInteger& other) { BoostInteger::make(*this, number(other)); }
BigInteger::BigInteger(BigInteger&& other) noexcept {
  BoostInteger::make(*this, std::move(number(other)));
}
BigInteger& BigInteger::operator=(const BigInteger& other) {
  number(*this) = number(other);
  return *this;
}
BigInteger& BigInteger::operator=(BigInteger&& other) noexcept {
  number(*this) = std::move(number(other));
  return *this;
}
BigInteger::~BigInteger() { std::destroy_at(&number(*this)); }

int BigInteger::sign() const { return number(*this).sign(); }
std::size_t BigInteger::limb_count() const { return number(*this).backend().size(); }
std::uint64_t BigInteger::limb(std::size_t i) const { return number(*this).backend().limbs()[i]; }
BigInteger::operator std::int64_t() const {
  return static_cast<std::int64_t>(sign() < 0 ? 0 - limb(0) : limb(0));
}
// Boost's way takes far longer. A bit is 0.301 digits, so `places` is a little less than half.
std::string BigInteger::to_string() const {
  if (bit_length(*this) < 64) return std::to_string(static_cast<std::int64_t>(*this));
  const std::size_t places = bit_length(*this) / 7;
  const auto [high, low] = divided(*this, power(10, static_cast<int>(places)));
  const std::string digits = abs(low).to_string();
  return high.to_string() + std::string(places - digits.size(), '0') + digits;
}

BigInteger& BigInteger::operator+=(const BigInteger& other) {
  number(*this) += number(other);
  return *this;
}
BigInteger& BigInteger::operator-=(const BigInteger& other) {
  number(*this) -= number(other);
  return *this;
}
BigInteger& BigInteger::operator<<=(std::int64_t bits) {
  number(*this) <<= bits;
  return *this;
}
BigInteger operator>>(const BigInteger& a, std::int64_t bits) { return made(number(a) >> bits); }
BigInteger operator+(const BigInteger& a, const BigInteger& b) {
  return made(number(a) + number(b));
}
BigInteger operator-(const BigInteger& a, const BigInteger& b) {
  return made(number(a) - number(b));
}
BigInteger operator*(const BigInteger& a, const BigInteger& b) {
  return made(number(a) * number(b));
}
BigInteger operator/(const BigInteger& a, const BigInteger& b) {
  return made(number(a) / number(b));
}
BigInteger operator%(const BigInteger& a, const BigInteger& b) {
  return made(number(a) % number(b));
}
BigInteger operator-(BigInteger a) {
  number(a).backend().negate();
  return a;
}
bool operator==(const BigInteger& a, const BigInteger& b) { return number(a) == number(b); }
std::strong_ordering operator<=>(const BigInteger& a, const BigInteger& b) {
  return number(a).compare(number(b)) <=> 0;
}

std::int64_t trailing_zeros(const BigInteger& value) {
  std::size_t limb = 0;
  while (value.limb(limb) == 0) ++limb;
  return static_cast<std::int64_t>(64 * limb) + std::countr_zero(value.limb(limb));
}

std::size_t bit_length(const BigInteger& value) {
  const std::size_t count = value.limb_count();
  return 64 * count - static_cast<std::size_t>(std::countl_zero(value.limb(count - 1)));
}

BigInteger power(int base, int exponent) {
  // 10^38 is below 2^127. Boost's way was a fifth of what rounding of decimals took.
  if (base <= 10 && exponent <= 38) {
    Int128 result = 1;
    for (int i = 0; i < exponent; ++i) result *= base;
    return result;
  }
  return made(mp::pow(BoostInteger::Number(base), static_cast<unsigned>(exponent)));
}

void scale(BigInteger& numerator, BigInteger& denominator, int exp2, int exp10) {
  if (exp10 != 0) (exp10 > 0 ? numerator : denominator) *= power(10, std::abs(exp10));
  (exp2 > 0 ? numerator : denominator) <<= std::abs(exp2);
}

Uint128 short_magnitude(const BigInteger& value) {
  return value.limb_count() == 1 ? value.limb(0) : Uint128{value.limb(1)} << 64 | value.limb(0);
}

std::size_t append_limbs(const BigInteger& value, std::vector<std::uint64_t>& limbs) {
  if (value.is_zero()) return 0;
  const auto* first = number(value).backend().limbs();
  limbs.insert(limbs.end(), first, first + value.limb_count());
  return value.limb_count();
}

Division divided(const BigInteger& value, const BigInteger& divisor) {
  Division result;
  mp::divide_qr(number(value), number(divisor), number(result.quotient), number(result.rest));
  return result;
}

Division divided_to_nearest(const BigInteger& value, const BigInteger& divisor) {
  Division result = divided(value, divisor);
  const auto to_half = (abs(result.rest) << 1) <=> divisor;
  if (to_half > 0 || (to_half == 0 && result.quotient.is_odd())) {
    result.quotient += value.sign();
    result.rest -= value.sign() * divisor;
  }
  return result;
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

int width_of(Uint128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  return high != 0 ? 128 - std::countl_zero(high)
                   : 64 - std::countl_zero(static_cast<std::uint64_t>(value));
}

// Returns the 64 highest bits of a magnitude, after zeros if there are fewer bits.
std::uint64_t leading_bits(const BigInteger& value) {
  const std::size_t last = value.limb_count() - 1;
  const int zeros = std::countl_zero(value.limb(last));
  const std::uint64_t high = value.limb(last) << zeros;
  return zeros == 0 || last == 0 ? high : high | value.limb(last - 1) >> (64 - zeros);
}

// Does what nearest_double does for a magnitude, if leading bits alone decide. All that they allow
// lies between two bounds, and rounding keeps order: so if both bounds become one double, it is the
// one. Otherwise this returns false, which is rare.
bool nearest_by_leading_bits(const BigInteger& numerator, const BigInteger& denominator,
                             std::int64_t exp2, double& nearest) {
  const std::uint64_t n = leading_bits(numerator);
  const std::uint64_t d = leading_bits(denominator);
  // Both n and d lie in [2^63, 2^64), so these quotients lie in [2^61, 2^63].
  const auto low = static_cast<std::uint64_t>((Uint128{n} << 62) / (Uint128{d} + 1));
  const auto high = static_cast<std::uint64_t>(((Uint128{n} + 1) << 62) / d) + 1;
  const std::int64_t exponent = exp2 - 62 + static_cast<std::int64_t>(bit_length(numerator)) -
                                static_cast<std::int64_t>(bit_length(denominator));
  nearest = round_to_double(low, false, exponent);
  return nearest == round_to_double(high, false, exponent);
}

}  // namespace

double nearest_double(Uint128 numerator, std::uint64_t denominator, std::int64_t exp2) {
  if (numerator == 0) return 0;
  const int shift = 63 - (width_of(numerator) - width_of(denominator));
  Uint128 divisor = denominator;
  (shift >= 0 ? numerator : divisor) <<= std::abs(shift);
  const Uint128 quotient = numerator / divisor;
  return round_to_double(static_cast<std::uint64_t>(quotient), quotient * divisor != numerator,
                         exp2 - shift);
}

double nearest_double(const BigInteger& numerator, const BigInteger& denominator,
                      std::int64_t exp2) {
  if (numerator.is_zero()) return 0;
  const auto excess = static_cast<std::int64_t>(bit_length(numerator)) -
                      static_cast<std::int64_t>(bit_length(denominator));
  if (excess + exp2 < -1100) return 0;
  double magnitude = 0;
  if (excess + exp2 > 1100) {
    magnitude = std::numeric_limits<double>::infinity();
  } else if (bit_length(numerator) <= 128 && bit_length(denominator) <= 64) {
    magnitude = nearest_double(short_magnitude(numerator), denominator.limb(0), exp2);
  } else if (!nearest_by_leading_bits(numerator, denominator, exp2, magnitude)) {
    // numerator · 2^shift / denominator lies in (2^62, 2^64), so the quotient has enough bits and
    // fits one limb.
    const std::int64_t shift = 63 - excess;
    const Division division = shift >= 0 ? divided(numerator << shift, denominator)
                                         : divided(numerator, denominator << -shift);
    magnitude = round_to_double(division.quotient.limb(0), !division.rest.is_zero(), exp2 - shift);
  }
  if (magnitude == 0) return 0;
  return numerator.sign() < 0 ? -magnitude : magnitude;
}

double to_double(const BigInteger& value) {
  if (bit_length(value) < 64) return static_cast<double>(static_cast<std::int64_t>(value));
  return nearest_double(value, 1);
}

}  // namespace minksum

// Converts Region's coordinates to their stored form and back, and compares them.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "region/rational_access.hpp"
#include "region/region_access.hpp"

namespace minksum {

namespace {

constexpr std::int64_t kExactDoubleLimit = std::int64_t{1} << 53;

StoredCoordinate compact(std::int64_t payload, int exp2, int exp10) {
  return {payload, static_cast<std::int16_t>(exp2), static_cast<std::int16_t>(exp10), 0, 0};
}

bool fits_int64(const BigInteger& value) { return bit_length(value) < 64; }

// Returns k if a number is 5^k, and -1 otherwise.
int exponent_of_five(const BigInteger& value) {
  // 5^k has one bit more than k · 2.3219, rounded down. So the quotient is k or k - 1.
  const auto exponent = static_cast<int>((bit_length(value) - 1) * 10'000 / 23'219);
  if (power(5, exponent) == value) return exponent;
  return power(5, exponent + 1) == value ? exponent + 1 : -1;
}

// Splits a quotient whose denominator is 2^a·5^b into an integer, which it returns, and exponents.
// With a denominator of up to 63 bits, it becomes m·10^-k if m fits 63 bits, since people write
// such decimals, whose grids are alike. Others become m·2^(b - a)·10^-b: of 20 digits and more, a
// few powers of ten make grids too fine.
std::optional<BigInteger> split_decimal(const BigInteger& numerator, const BigInteger& denominator,
                                        StoredCoordinate& out) {
  constexpr std::size_t kMostBits = 1100;  // 10^-324, less than any double, has 1,077
  const std::size_t bits = bit_length(denominator);
  if (bits > kMostBits) return std::nullopt;
  const auto twos = static_cast<int>(trailing_zeros(denominator));
  const int fives = exponent_of_five(denominator >> twos);
  if (fives < 0) return std::nullopt;
  if (bits < 64 && fits_int64(numerator)) {
    BigInteger payload =
        twos < fives ? numerator << (fives - twos) : numerator * power(5, twos - fives);
    if (fits_int64(payload)) {
      out = compact(0, 0, -std::max(twos, fives));
      return payload;
    }
  }
  out = compact(0, fives - twos, -fives);
  return numerator;
}

// Stores an odd number of 63 bits times a power of two.
bool store_as_binary(const BigInteger& numerator, const BigInteger& denominator,
                     StoredCoordinate& out) {
  const std::int64_t up = trailing_zeros(numerator);
  const std::int64_t down = trailing_zeros(denominator);
  if (bit_length(denominator) != static_cast<std::size_t>(down) + 1) return false;
  if (up > INT16_MAX || down > INT16_MAX) return false;
  const BigInteger odd = abs(numerator) >> up;
  if (!fits_int64(odd)) return false;
  const auto payload = static_cast<std::int64_t>(odd);
  out = compact(numerator.sign() < 0 ? -payload : payload, static_cast<int>(up - down), 0);
  return true;
}

constexpr std::array<double, 23> kDoublePowersOfTen = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kLargestPower = 22;

// A double's bits: 52 of its mantissa, then its exponent plus the bias.
constexpr int kMantissaBits = 52;
constexpr int kBias = 1023;
constexpr std::int64_t kHiddenBit = std::int64_t{1} << kMantissaBits;

bool is_normal_exponent(int exponent) { return -kBias < exponent && exponent <= kBias; }

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kBias) << kMantissaBits);
}

// Rounds m · 2^exp2 · 10^exp10 in the cases that take one rounding of exact doubles.
bool nearest_quick(const StoredCoordinate& c, double& result) {
  const bool exact_mantissa = c.payload <= kExactDoubleLimit && c.payload >= -kExactDoubleLimit;
  if (c.exp10 == 0) {
    // int64 to double rounds to nearest even. With an exponent, there must be one rounding only.
    result = static_cast<double>(c.payload);
    if (c.exp2 == 0) return true;
    if (!exact_mantissa) return false;
    // One rounding (of denormals), or an infinity.
    result =
        is_normal_exponent(c.exp2) ? result * power_of_two(c.exp2) : std::ldexp(result, c.exp2);
    if (result == 0) result = 0.0;  // never -0
    return true;
  }
  if (c.exp2 != 0) return false;
  if (exact_mantissa && std::abs(c.exp10) <= kLargestPower) {  // one rounding of exact operands
    const auto mantissa = static_cast<double>(c.payload);
    result = c.exp10 < 0 ? mantissa / kDoublePowersOfTen[static_cast<std::size_t>(-c.exp10)]
                         : mantissa * kDoublePowersOfTen[static_cast<std::size_t>(c.exp10)];
    return true;
  }
  return false;
}

// Returns the value of up to two limbs, with a relative error below 2^-52.
double about(const std::uint64_t* limbs, std::size_t count) {
  const double low = count > 0 ? static_cast<double>(limbs[0]) : 0;
  return count > 1 ? static_cast<double>(limbs[1]) * 0x1p64 + low : low;
}

}  // namespace

StoredCoordinate Region::store(const Rational& value) {
  const BigInteger& numerator = RationalAccess::numerator(value);
  const BigInteger& denominator = RationalAccess::denominator(value);
  if (numerator.is_zero()) return {};
  StoredCoordinate result;
  if (denominator == 1 && fits_int64(numerator)) {
    return compact(static_cast<std::int64_t>(numerator), 0, 0);
  }
  if (store_as_binary(numerator, denominator, result)) return result;
  const std::optional<BigInteger> payload = split_decimal(numerator, denominator, result);
  if (payload && fits_int64(*payload)) {
    result.payload = static_cast<std::int64_t>(*payload);
    return result;
  }
  std::vector<std::uint64_t> limbs;
  const std::size_t above = append_limbs(numerator, limbs);
  const std::size_t below = append_limbs(payload ? BigInteger(1) : denominator, limbs);
  if (above > kLimbCountMask || below > UINT16_MAX) {
    throw Error(ErrorCode::kLimitExceeded, "a coordinate of more than 2 million bits");
  }
  result.payload = static_cast<std::int64_t>(arrays_.size<kLimbs>());
  arrays_.append<kLimbs>(limbs);
  result.numerator_limbs =
      static_cast<std::uint16_t>(above | (numerator.sign() < 0 ? kNegativeLimbs : 0U));
  result.denominator_limbs = static_cast<std::uint16_t>(below);
  return result;
}

StoredCoordinate Region::store(double value) {
  if (value == 0) return {};
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>(bits >> kMantissaBits) & (2 * kBias + 1);
  auto mantissa = static_cast<std::int64_t>(bits) & (kHiddenBit - 1);
  if (biased != 0) mantissa += kHiddenBit;
  // An integer stays an integer. Any other number becomes odd times a power of two.
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  mantissa >>= zeros;
  const int exponent = std::max(biased, 1) - kBias - kMantissaBits + zeros;
  if (value < 0) mantissa = -mantissa;
  if (exponent > 0 && exponent + kMantissaBits + 1 - zeros < 63) {
    return compact(mantissa * (std::int64_t{1} << exponent), 0, 0);
  }
  return compact(mantissa, exponent, 0);
}

Rational Region::exact(const StoredCoordinate& c) const {
  if (c.denominator_limbs == 0 && c.exp2 == 0 && c.exp10 == 0) return Rational(c.payload);
  auto [numerator, denominator] = RegionAccess::quotient(*this, c);
  return RationalAccess::make(std::move(numerator), std::move(denominator), c.exp2, c.exp10);
}

double Region::nearest(const StoredCoordinate& c) const {
  double result = 0;
  if (c.denominator_limbs == 0 && (c.payload == 0 || nearest_quick(c, result))) return result;
  if (const auto brief = RegionAccess::short_quotient(*this, c)) {
    result = nearest_double(brief->numerator, brief->denominator, c.exp2);
    return brief->negative && result != 0 ? -result : result;
  }
  // The quotient is not in lowest terms: finding these would cost more than the rounding.
  auto [numerator, denominator] = RegionAccess::quotient(*this, c);
  scale(numerator, denominator, 0, c.exp10);
  return nearest_double(numerator, denominator, c.exp2);
}

std::optional<ShortQuotient> RegionAccess::short_quotient(const Region& region,
                                                          const StoredCoordinate& c) {
  constexpr int kMostTens = 19;  // 10^19 has 64 bits
  if (c.exp10 > 0 || c.exp10 < -kMostTens) return {};
  std::uint64_t tens = 1;
  for (int k = c.exp10; k < 0; ++k) tens *= 10;
  if (c.denominator_limbs == 0) {
    const auto size = static_cast<std::uint64_t>(c.payload);
    return ShortQuotient{c.payload < 0 ? 0 - size : size, tens, c.payload < 0};
  }
  const std::size_t above = c.numerator_limbs & kLimbCountMask;
  if (c.denominator_limbs > 1 || above > 2) return {};
  const std::uint64_t* digits = limbs(region).data() + c.payload;
  ShortQuotient result;
  if (__builtin_mul_overflow(digits[above], tens, &result.denominator)) return {};
  if (above > 0) result.numerator = digits[0];
  if (above > 1) result.numerator |= Uint128{digits[1]} << 64;
  result.negative = (c.numerator_limbs & kNegativeLimbs) != 0;
  return result;
}

Quotient<BigInteger> RegionAccess::quotient(const Region& region, const StoredCoordinate& c) {
  if (c.denominator_limbs == 0) return {c.payload, 1};
  const auto digits = limbs(region).subspan(static_cast<std::size_t>(c.payload));
  const std::size_t above = c.numerator_limbs & kLimbCountMask;
  return {BigInteger(digits.first(above), (c.numerator_limbs & kNegativeLimbs) != 0),
          BigInteger(digits.subspan(above, c.denominator_limbs))};
}

std::strong_ordering RegionAccess::compare(const Region& region, const StoredCoordinate& a,
                                           const StoredCoordinate& b) {
  const bool on_one_grid =
      (a.exp2 == b.exp2 && a.exp10 == b.exp10) || a.payload == 0 || b.payload == 0;
  if (a.denominator_limbs == 0 && b.denominator_limbs == 0 && on_one_grid) {
    return a.payload <=> b.payload;
  }
  const auto near = [&](const StoredCoordinate& c) {
    const std::size_t above = c.numerator_limbs & kLimbCountMask;
    const bool quick = c.denominator_limbs > 0 && c.denominator_limbs <= 2 && above <= 2 &&
                       c.exp10 <= 0 && c.exp10 >= -kLargestPower;
    if (!quick) return region.nearest(c);
    const std::uint64_t* digits = region.arrays_.get<Region::kLimbs>().data() + c.payload;
    const double size = about(digits, above) / about(digits + above, c.denominator_limbs) /
                        kDoublePowersOfTen[static_cast<std::size_t>(-c.exp10)];
    return std::ldexp((c.numerator_limbs & kNegativeLimbs) != 0 ? -size : size, c.exp2);
  };
  const double x = near(a);
  const double y = near(b);
  // The slack is far more than the errors of both, and than the smallest normal double.
  const double slack = (std::abs(x) + std::abs(y)) * 0x1p-45 + 1e-290;
  if (x - y > slack) return std::strong_ordering::greater;
  if (y - x > slack) return std::strong_ordering::less;
  return region.exact(a) <=> region.exact(b);
}

bool operator==(const Region& a, const Region& b) {
  const auto points = a.vertices();
  const auto others = b.vertices();
  if (points.size() != others.size() ||
      !std::ranges::equal(a.arrays_.get<Region::kPolygonStarts>(),
                          b.arrays_.get<Region::kPolygonStarts>()) ||
      !std::ranges::equal(a.arrays_.get<Region::kRingStarts>(),
                          b.arrays_.get<Region::kRingStarts>())) {
    return false;
  }
  const auto equal = [&](const StoredCoordinate& p, const StoredCoordinate& q) {
    if (p.denominator_limbs == 0 && q.denominator_limbs == 0 && p.exp2 == q.exp2 &&
        p.exp10 == q.exp10) {
      return p.payload == q.payload;
    }
    return a.exact(p) == b.exact(q);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!equal(points[i].x, others[i].x)) return false;
    if (!equal(points[i].y, others[i].y)) return false;
  }
  return true;
}

}  // namespace minksum

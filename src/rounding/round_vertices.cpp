#include "rounding/round_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "region/map_points.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

/// The number numerator / denominator · 2^exp2. The quotient is not in lowest terms, because
/// finding these would cost more than the rounding.
struct Scaled {
  BigInteger numerator;
  BigInteger denominator = 1;
  int exp2 = 0;
};

Scaled scaled(const Region& region, const StoredCoordinate& c, int exp10) {
  auto [numerator, denominator] = RegionAccess::quotient(region, c);
  scale(numerator, denominator, 0, exp10 + c.exp10);
  return {std::move(numerator), std::move(denominator), c.exp2};
}

/// Returns numerator / denominator · 2^exp2 as a double, which is 0 only if the number is.
double signed_double(const BigInteger& numerator, const BigInteger& denominator, int exp2) {
  if (numerator.is_zero()) return 0;
  const double nearest = nearest_double(numerator, denominator, exp2);
  return nearest != 0 ? nearest : numerator.sign() * std::numeric_limits<double>::denorm_min();
}

/// Returns a double as an integer times a power of two.
std::pair<std::int64_t, int> mantissa_and_exponent(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

/// Tells whether a coordinate is stored without a denominator and equals its nearest double.
bool is_exactly(const StoredCoordinate& c, double value) {
  if (c.denominator_limbs != 0) return false;
  if (c.payload == 0) return true;
  if (c.exp10 != 0) return false;
  constexpr std::int64_t kLargest = std::int64_t{1} << 53;
  return c.payload >= -kLargest && c.payload <= kLargest &&
         std::ldexp(value, -c.exp2) == static_cast<double>(c.payload);
}

/// Returns the difference of a short number from its nearest double.
std::optional<double> off_nearest(const Region& region, const StoredCoordinate& c, double value) {
  const auto brief = RegionAccess::short_quotient(region, c);
  const auto [mantissa, exponent] = mantissa_and_exponent(std::abs(value));
  const int shift = c.exp2 - exponent;
  if (!brief || !std::isnormal(value) || shift < 0 || shift > 127) return {};
  // In units of 2^exponent / denominator, the difference is half of the denominator at most. So
  // the lowest 128 bits of both products tell it.
  const auto more = static_cast<Int128>((brief->numerator << shift) -
                                        static_cast<Uint128>(mantissa) * brief->denominator);
  return signed_double(brief->negative ? -more : more, brief->denominator, exponent);
}

double off_double(const Region& region, const StoredCoordinate& c, double value) {
  if (is_exactly(c, value)) return 0;
  if (const auto off = off_nearest(region, c, value)) return *off;
  Scaled exact = scaled(region, c, 0);
  const auto [mantissa, exponent] = mantissa_and_exponent(value);
  const int low = mantissa == 0 ? exact.exp2 : std::min(exact.exp2, exponent);
  exact.numerator <<= exact.exp2 - low;
  if (mantissa != 0) {
    exact.numerator -= (exact.denominator * mantissa) << (exponent - low);
  }
  return signed_double(exact.numerator, exact.denominator, low);
}

RoundedCoordinate decimal_place(BigInteger integer) {
  RoundedCoordinate place;
  place.value = to_double(integer);
  place.integer = std::move(integer);
  return place;
}

RoundedCoordinate round_decimal(const Region& region, const StoredCoordinate& c, int decimals,
                                double& off) {
  constexpr int kShort = 18;
  const int tens = c.exp10 + decimals;
  off = 0;
  if (c.denominator_limbs == 0 && c.payload == 0) return {};
  if (c.denominator_limbs == 0 && c.exp2 == 0 && tens >= 0 && tens <= kShort) {
    return decimal_place(BigInteger(c.payload) * power(10, tens));
  }
  Scaled exact = scaled(region, c, decimals);
  scale(exact.numerator, exact.denominator, exact.exp2, 0);
  auto [integer, rest] = divided_to_nearest(exact.numerator, exact.denominator);
  off = signed_double(rest, exact.denominator, 0);
  return decimal_place(std::move(integer));
}

}  // namespace

Rational Target::unit() const { return decimals ? Rational(Decimal{1, -*decimals}) : Rational(1); }

void fail_beyond_doubles(const Culprit& place) {
  throw Error(ErrorCode::kLimitExceeded, "a coordinate is beyond the range of doubles", place, {},
              ExceededLimit{"doubles"});
}

RoundedVertices round_vertices(const Region& region, const Target& target,
                               Cancellation& cancellation) {
  const std::size_t digits =
      target.is_decimal() ? 4 * static_cast<std::size_t>(*target.decimals) : 64;
  RoundedVertices result(region.vertex_count());
  const auto round_one = [&](std::size_t v, const StoredCoordinate& c, RoundedCoordinate& place,
                             double& off) {
    if (target.is_decimal()) {
      place = round_decimal(region, c, *target.decimals, off);
      return;
    }
    place.value = RegionAccess::nearest(region, c);
    if (!std::isfinite(place.value)) {
      fail_beyond_doubles(RegionAccess::culprit(region, v));
    }
    off = off_double(region, c, place.value);
  };
  for (std::size_t v = 0; v < result.size(); ++v) {
    cancellation.check(8 + 4 * work_of_product(RegionAccess::bits(region, v) + digits));
    round_one(v, RegionAccess::x(region, v), result[v].x, result[v].off_x);
    round_one(v, RegionAccess::y(region, v), result[v].y, result[v].off_y);
  }
  return result;
}

RoundedCoordinate nearest_place(const Rational& value, const Target& target) {
  if (!target.is_decimal()) return {value.to_double(), {}};
  const Rational steps = value / target.unit();
  return decimal_place(
      divided_to_nearest(RationalAccess::numerator(steps), RationalAccess::denominator(steps))
          .quotient);
}

Rational value_of(const RoundedCoordinate& place, const Target& target) {
  if (!target.is_decimal()) return Rational(place.value);
  return RationalAccess::make(place.integer, 1, 0, -*target.decimals);
}

RoundedCoordinate next_place(const RoundedCoordinate& place, bool up, const Target& target) {
  if (target.is_decimal()) return decimal_place(place.integer + (up ? 1 : -1));
  const double next = std::nextafter(place.value, up ? HUGE_VAL : -HUGE_VAL);
  return {next == 0 ? 0.0 : next, {}};
}

RoundedCoordinate shifted_place(const RoundedCoordinate& place, double steps, double step,
                                const Target& target) {
  if (target.is_decimal()) {
    return decimal_place(place.integer + static_cast<std::int64_t>(steps));
  }
  return {place.value + steps * step + 0.0, {}};
}

void add_vertex(Region& region, const RoundedCoordinate& x, const RoundedCoordinate& y,
                const Target& target) {
  if (!target.is_decimal()) {
    region.add_vertex(x.value, y.value);
    return;
  }
  if (bit_length(x.integer) < 64 && bit_length(y.integer) < 64) {
    region.add_vertex(Decimal{static_cast<std::int64_t>(x.integer), -*target.decimals},
                      Decimal{static_cast<std::int64_t>(y.integer), -*target.decimals});
    return;
  }
  region.add_vertex(value_of(x, target), value_of(y, target));
}

Region with_vertices(const Region& region, const RoundedVertices& vertices, const Target& target,
                     Cancellation& cancellation) {
  return with_same_rings(region, [&](Region& result, std::size_t v) {
    cancellation.check(32);
    add_vertex(result, vertices[v].x, vertices[v].y, target);
  });
}

double largest_move(const RoundedVertices& vertices) {
  double largest = 0;
  for (const RoundedVertex& v : vertices) {
    if (v.moved()) largest = std::max(largest, rounded_up(length_of(v.off_x, v.off_y)));
  }
  return largest;
}

double length_of(double x, double y) {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (larger == 0 || !std::isfinite(larger)) return larger;
  const double u = x / larger;
  const double v = y / larger;
  return larger * std::sqrt(u * u + v * v);
}

double rounded_up(double length) { return std::nextafter(length * (1 + 0x1p-49), HUGE_VAL); }

double rounded_up(const Rational& value) {
  const double nearest = value.to_double();
  if (!std::isfinite(nearest) || Rational(nearest) >= value) return nearest;
  return std::nextafter(nearest, HUGE_VAL);
}

}  // namespace minksum

#include "region/common_scale.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "exact/gcd.hpp"
#include "machine/make_room.hpp"
#include "region/fraction_sum.hpp"
#include "region/rational_access.hpp"
#include "region/region_access.hpp"

namespace minksum {

namespace {

constexpr std::int64_t kLargest = (std::int64_t{1} << 61) - 1;

// Sets `result` to payload · 2^twos · 10^tens, if the magnitude of that is at most kLargest.
bool scaled(std::int64_t payload, int twos, int tens, std::int64_t& result) {
  result = payload;
  if (payload == 0) return true;
  if (twos > 61 || tens > 18) return false;
  for (; tens > 0; --tens) {
    if (result > kLargest / 10 || result < -kLargest / 10) return false;
    result *= 10;
  }
  const std::int64_t limit = kLargest >> twos;
  if (result > limit || result < -limit) return false;
  result *= std::int64_t{1} << twos;
  return true;
}

// Collects denominators. For finite decimals and doubles, exponents tell the powers of two and of
// five. Other denominators are kept as they are.
class Denominators {
 public:
  Denominators(const Region& region, Cancellation& cancellation) {
    for (std::size_t v = 0; v < region.vertex_count(); ++v) {
      cancellation.check(work_of_product(RegionAccess::bits(region, v)));
      add(region, RegionAccess::x(region, v));
      add(region, RegionAccess::y(region, v));
    }
  }
  [[nodiscard]] BigInteger finite() const { return power(5, fives_) << twos_; }
  [[nodiscard]] BigInteger least_common(Cancellation& cancellation) {
    return least_common_multiple(finite(), std::move(others_), cancellation);
  }

 private:
  void add(const Region& region, const StoredCoordinate& c) {
    if (c.denominator_limbs != 0) {
      const Rational value = RegionAccess::exact(region, c);
      others_.push_back(RationalAccess::denominator(value));
      return;
    }
    if (c.payload == 0) return;
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(c.payload));
    twos_ = std::max(twos_, -(int{c.exp2} + int{c.exp10} + zeros));
    int fives = -int{c.exp10};
    for (std::int64_t rest = c.payload; fives > fives_ && rest % 5 == 0; rest /= 5) --fives;
    fives_ = std::max(fives_, fives);
  }

  int twos_ = 0;
  int fives_ = 0;
  std::vector<BigInteger> others_;
};

}  // namespace

// Takes one value after the other. The common divisor of two long numbers takes time quadratic in
// their length. That of a long and a short number takes hardly more than a division.
BigInteger least_common_multiple(BigInteger common, std::vector<BigInteger> values,
                                 Cancellation& cancellation) {
  sort_unique(values, cancellation);
  for (const BigInteger& value : values) {
    cancellation.check(8 * work_of_product(bit_length(value)) + bit_length(common) / 16);
    const BigInteger rest = divided(common, value, cancellation).rest;
    common *= value / greatest_common_divisor(rest, value);
  }
  return common;
}

bool find_common_scale(const Region& region, Cancellation& cancellation, CommonScale& scale) {
  int twos = 0;
  int tens = 0;
  bool any = false;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    cancellation.check();
    for (const StoredCoordinate* c : {&RegionAccess::x(region, v), &RegionAccess::y(region, v)}) {
      if (c->denominator_limbs != 0) return false;
      if (c->payload == 0) continue;
      twos = any ? std::min(twos, int{c->exp2}) : int{c->exp2};
      tens = any ? std::min(tens, int{c->exp10}) : int{c->exp10};
      any = true;
    }
  }
  scale.points.resize(region.vertex_count());
  const auto place = [&](const StoredCoordinate& c, std::int64_t& result) {
    return scaled(c.payload, c.exp2 - twos, c.exp10 - tens, result);
  };
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    cancellation.check(2);
    ScaledPoint& point = scale.points[v];
    if (!place(RegionAccess::x(region, v), point.x)) return false;
    if (!place(RegionAccess::y(region, v), point.y)) return false;
  }
  scale.unit = RationalAccess::make(1, 1, twos, tens);
  return true;
}

BigInteger finite_denominator(const Region& region, Cancellation& cancellation) {
  return Denominators(region, cancellation).finite();
}

BigInteger least_common_denominator(const Region& region, Cancellation& cancellation) {
  return Denominators(region, cancellation).least_common(cancellation);
}

}  // namespace minksum

#include "region/denominators.hpp"

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

BigInteger finite_denominator(const Region& region, Cancellation& cancellation) {
  return Denominators(region, cancellation).finite();
}

BigInteger least_common_denominator(const Region& region, Cancellation& cancellation) {
  return Denominators(region, cancellation).least_common(cancellation);
}

}  // namespace minksum

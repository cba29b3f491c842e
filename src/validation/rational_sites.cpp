#include "validation/rational_sites.hpp"

#include <algorithm>
#include <limits>

#include "region/region_access.hpp"

namespace minksum {
namespace {

/// Returns numerator / denominator · 2^exp2 · 10^exp10.
Fraction scaled(BigInteger numerator, BigInteger denominator, int exp2, int exp10) {
  scale(numerator, denominator, exp2, exp10);
  return Fraction(std::move(numerator), std::move(denominator)).reduced();
}

Fraction as_rational(const Region& region, const StoredCoordinate& c) {
  Quotient<BigInteger> value = RegionAccess::quotient(region, c);
  return scaled(std::move(value.numerator), std::move(value.denominator), c.exp2, c.exp10);
}

/// Sets the box and the bits.
void measure(Cancellation& cancellation, RationalCoordinates& rationals) {
  rationals.bits = 0;
  if (rationals.sites.empty()) return;
  Vec<Fraction> low = rationals.sites[0];
  Vec<Fraction> high = low;
  for (const auto& s : rationals.sites) {
    if (s.x < low.x) low.x = s.x;
    if (s.y < low.y) low.y = s.y;
    if (high.x < s.x) high.x = s.x;
    if (high.y < s.y) high.y = s.y;
    cancellation.check(work_of_decision(rationals.bits));
    for (const Fraction* const c : {&s.x, &s.y}) {
      rationals.bits =
          std::max({rationals.bits, bit_length(c->numerator()), bit_length(c->denominator())});
    }
  }
  rationals.low = low;
  rationals.extent = {(high.x - low.x).reduced(), (high.y - low.y).reduced()};
}

}  // namespace

void load_rationals(const Region& region, Cancellation& cancellation,
                    RationalCoordinates& rationals) {
  rationals.sites.clear();
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    cancellation.check(work_of_decision(RegionAccess::bits(region, v)));
    rationals.sites.push_back({as_rational(region, RegionAccess::x(region, v)),
                               as_rational(region, RegionAccess::y(region, v))});
  }
  measure(cancellation, rationals);
}

RationalCoordinates rationals_of(const PreparedOperand& operand, std::span<const SiteId> sites,
                                 const GridUnit& unit, Cancellation& cancellation) {
  RationalCoordinates result;
  result.sites.reserve(sites.size());
  if (operand.rational) {
    const RationalCoordinates& all = operand.rationals;
    for (const SiteId site : sites) {
      cancellation.check(work_of_product(all.bits));
      result.sites.push_back(all.sites[site]);
    }
    result.low = all.low;
    result.extent = all.extent;
    result.bits = all.bits;
    return result;
  }
  const GridCoordinates& grid = operand.grid;
  const Fraction factor = scaled(unit.divisor, grid.unit.divisor, grid.unit.exp2 - unit.exp2,
                                 grid.unit.exp10 - unit.exp10);
  const auto in_unit = [&](const BigInteger& on_grid) { return Fraction(on_grid) * factor; };
  const auto point = [&](const auto& at) {
    return Vec<Fraction>{in_unit(BigInteger(at.x) + grid.offset.x),
                         in_unit(BigInteger(at.y) + grid.offset.y)};
  };
  result.low = point(Vec<Int128>{});
  result.extent = {in_unit(grid.extent.x), in_unit(grid.extent.y)};
  result.bits = bit_length(factor.denominator());
  for (const Vec<Fraction>& corner : {result.low, point(grid.extent)}) {
    result.bits =
        std::max({result.bits, bit_length(corner.x.numerator()), bit_length(corner.y.numerator())});
  }
  for (const SiteId site : sites) {
    cancellation.check(work_of_product(result.bits));
    Vec<Fraction> at = grid.small ? point(grid.small_sites[site]) : point(grid.large_sites[site]);
    if (!factor.is_integer()) at = {at.x.reduced(), at.y.reduced()};
    result.sites.push_back(std::move(at));
  }
  return result;
}

int rational_exponent(std::span<const Vec<Fraction>> extents) {
  int log2_extent = std::numeric_limits<int>::min();
  for (const auto& extent : extents) {
    for (const Fraction* const side : {&extent.x, &extent.y}) {
      if (sign_of(*side) == kZero) continue;
      const int log2_above = static_cast<int>(bit_length(side->numerator())) -
                             static_cast<int>(bit_length(side->denominator())) + 1;
      log2_extent = std::max(log2_extent, log2_above);
    }
  }
  const bool empty = log2_extent == std::numeric_limits<int>::min();
  return empty ? 0 : kRationalExtentBits - log2_extent;
}

}  // namespace minksum

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

Fraction grid_coordinate(Int128 integer, Int128 offset, const GridCoordinates& grid) {
  return scaled(BigInteger(integer) + offset, grid.unit.divisor, grid.unit.exp2, grid.unit.exp10);
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
  measure_rationals(cancellation, rationals);
}

void measure_rationals(Cancellation& cancellation, RationalCoordinates& rationals) {
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

RationalCoordinates rationals_of(const PreparedOperand& operand, std::span<const SiteId> sites,
                                 Cancellation& cancellation) {
  RationalCoordinates result;
  const GridCoordinates& grid = operand.grid;
  const std::uint64_t work =
      work_of_product(operand.rational ? operand.rationals.bits : std::size_t{256});
  for (const SiteId site : sites) {
    cancellation.check(work);
    if (operand.rational) {
      result.sites.push_back(operand.rationals.sites[site]);
      continue;
    }
    const Vec<Int128> at = grid.small
                               ? Vec<Int128>{grid.small_sites[site].x, grid.small_sites[site].y}
                               : grid.large_sites[site];
    result.sites.push_back({grid_coordinate(at.x, grid.offset.x, grid),
                            grid_coordinate(at.y, grid.offset.y, grid)});
  }
  measure_rationals(cancellation, result);
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

// Coordinates from the operands' own numbers to one common grid, and the rung that they need.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "operands/operands.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

/// Above this a scaled coordinate no longer goes to fixed-width arithmetic. Differences of two have one
/// bit more.
constexpr int kMaxGridBits = WideRung::kCoordinateBits - 1;

struct Exponents {
  int exp2 = 0;
  int exp10 = 0;
  bool any = false;
  bool quotients = false;
  int bits = 0;
};

const StoredCoordinate& stored(const Region& region, std::size_t v, Axis axis) {
  return axis == Axis::kX ? RegionAccess::x(region, v) : RegionAccess::y(region, v);
}

template <class Visit>
void for_each_coordinate(const Region& p, const Region& q, Visit visit) {
  for (const Region* region : {&p, &q}) {
    for (std::size_t v = 0; v < region->vertex_count(); ++v) {
      visit(*region, RegionAccess::x(*region, v));
      visit(*region, RegionAccess::y(*region, v));
    }
  }
}

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}

/// The common scale: the smallest powers of two and ten in use.
Exponents common_exponents(const Region& p, const Region& q) {
  Exponents common;
  for_each_coordinate(p, q, [&](const Region&, const StoredCoordinate& c) {
    if (c.denominator_limbs != 0) {
      common.quotients = true;
    } else if (c.payload != 0) {
      common.exp2 = common.any ? std::min<int>(common.exp2, c.exp2) : c.exp2;
      common.exp10 = common.any ? std::min<int>(common.exp10, c.exp10) : c.exp10;
      common.any = true;
    }
  });
  if (common.quotients) return common;
  for_each_coordinate(p, q, [&](const Region&, const StoredCoordinate& c) {
    if (c.payload == 0) return;
    // 10^k needs at most ⌈k · 3.33⌉ bits.
    const int tens = ((c.exp10 - common.exp10) * 10 + 2) / 3;
    common.bits = std::max(common.bits, static_cast<int>(std::bit_width(magnitude(c.payload))) +
                                            (c.exp2 - common.exp2) + tens);
  });
  return common;
}

Int128 on_grid(const StoredCoordinate& c, const Exponents& common) {
  if (c.payload == 0) return 0;
  Int128 value = c.payload;
  for (int i = common.exp10; i < c.exp10; ++i) value *= 10;
  return value * (Int128{1} << (c.exp2 - common.exp2));
}

int bit_width(Int128 value) {
  const auto high = static_cast<std::uint64_t>(static_cast<Uint128>(value) >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

Arithmetic rung_for(int bits, Arithmetic asked) {
  const Arithmetic needed = bits <= NarrowRung::kCoordinateBits   ? Arithmetic::kNarrow
                            : bits <= MediumRung::kCoordinateBits ? Arithmetic::kMedium
                                                                  : Arithmetic::kWide;
  return std::max(needed, asked);
}

/// Moves one operand's sites so that its box starts at the origin.
void move_to_origin(std::span<Vec<Int128>> sites, Vec<Int128>& offset, int& bits,
                    Vec<double>& extent) {
  if (sites.empty()) return;
  Vec<Int128> low = sites[0];
  Vec<Int128> high = sites[0];
  for (const auto& s : sites) {
    low = {std::min(low.x, s.x), std::min(low.y, s.y)};
    high = {std::max(high.x, s.x), std::max(high.y, s.y)};
  }
  for (auto& s : sites) s = {s.x - low.x, s.y - low.y};
  offset = {offset.x + low.x, offset.y + low.y};
  bits = std::max({bits, bit_width(high.x - low.x), bit_width(high.y - low.y)});
  extent = {static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y)};
}

void load_grid(const Region& p, const Region& q, const Exponents& common, const Options& options,
               Operands& operands) {
  GridCoordinates& grid = operands.scratch.grid;
  grid.sites.clear();
  for (const Region* region : {&p, &q}) {
    for (std::size_t v = 0; v < region->vertex_count(); ++v) {
      grid.sites.push_back({on_grid(stored(*region, v, Axis::kX), common),
                            on_grid(stored(*region, v, Axis::kY), common)});
    }
  }
  grid.offset = {0, 0};
  grid.exp2 = common.exp2;
  grid.exp10 = common.exp10;
  grid.bits = 0;
  const std::span<Vec<Int128>> all(grid.sites);
  move_to_origin(all.first(operands.split), grid.offset, grid.bits, operands.extent[0]);
  move_to_origin(all.subspan(operands.split), grid.offset, grid.bits, operands.extent[1]);
  operands.bits = static_cast<std::uint64_t>(grid.bits);
  make_grid_kernel(rung_for(grid.bits, options.arithmetic), grid, operands.kernel);
  operands.bounds = RoundingBounds::of(std::ldexp(1.0, grid.bits), grid.bits <= kExactSumBits,
                                       grid.bits <= kExactProductBits);
  operands.trace_unit = std::ldexp(1.0, common.exp2) * std::pow(10.0, common.exp10);
  operands.trace_origin = {static_cast<double>(grid.offset.x) * operands.trace_unit,
                           static_cast<double>(grid.offset.y) * operands.trace_unit};
}

BigInteger big_power(int base, int exponent) {
  return boost::multiprecision::pow(BigInteger(base), static_cast<unsigned>(exponent));
}

BigRational as_rational(const Region& region, const StoredCoordinate& c) {
  BigInteger numerator(c.payload);
  BigInteger denominator(1);
  if (c.denominator_limbs != 0) {
    const auto limbs = RegionAccess::limbs(region).subspan(static_cast<std::size_t>(c.payload));
    const std::size_t n = c.numerator_limbs & kLimbCountMask;
    numerator = 0;
    const auto digits = limbs.first(n);
    if (n != 0) {
      boost::multiprecision::import_bits(numerator, digits.begin(), digits.end(), 64, false);
    }
    if ((c.numerator_limbs & kNegativeLimbs) != 0) numerator = -numerator;
    const auto rest = limbs.subspan(n, c.denominator_limbs);
    boost::multiprecision::import_bits(denominator, rest.begin(), rest.end(), 64, false);
  }
  (c.exp2 >= 0 ? numerator : denominator) *= big_power(2, std::abs(c.exp2));
  (c.exp10 >= 0 ? numerator : denominator) *= big_power(10, std::abs(c.exp10));
  return BigRational(numerator, denominator);
}

std::size_t bit_width(const BigInteger& value) {
  return value == 0 ? 0 : boost::multiprecision::msb(BigInteger(abs(value))) + 1;
}

/// Bits of numerator and denominator; and about the binary logarithm, for scaling.
std::size_t rational_bits(const BigRational& r) {
  return std::max(bit_width(BigInteger(boost::multiprecision::numerator(r))),
                  bit_width(BigInteger(boost::multiprecision::denominator(r))));
}
int log2_above(const BigRational& r) {
  const auto n = bit_width(BigInteger(boost::multiprecision::numerator(r)));
  const auto d = bit_width(BigInteger(boost::multiprecision::denominator(r)));
  return static_cast<int>(n) - static_cast<int>(d) + 1;
}

struct RationalBox {
  Vec<BigRational> low;
  Vec<BigRational> high;
};
RationalBox box_of(std::span<const Vec<BigRational>> sites) {
  RationalBox box;
  if (sites.empty()) return box;
  box = {sites[0], sites[0]};
  for (const auto& s : sites) {
    box.low = {std::min(box.low.x, s.x), std::min(box.low.y, s.y)};
    box.high = {std::max(box.high.x, s.x), std::max(box.high.y, s.y)};
  }
  return box;
}

void load_rationals(const Region& p, const Region& q, Operands& operands) {
  constexpr int kExtentBits = 60;  // keeps squares and fifth powers of extents in range
  std::vector<Vec<BigRational>> sites;
  std::size_t bits = 0;
  for (const Region* region : {&p, &q}) {
    for (std::size_t v = 0; v < region->vertex_count(); ++v) {
      sites.push_back({as_rational(*region, stored(*region, v, Axis::kX)),
                       as_rational(*region, stored(*region, v, Axis::kY))});
      bits = std::max({bits, rational_bits(sites.back().x), rational_bits(sites.back().y)});
    }
  }
  const std::span<const Vec<BigRational>> all(sites);
  const std::array<RationalBox, 2> box{box_of(all.first(operands.split)),
                                       box_of(all.subspan(operands.split))};
  int log2_extent = std::numeric_limits<int>::min();
  for (const auto& b : box) {
    for (const BigRational& side : {BigRational(b.high.x - b.low.x), BigRational(b.high.y - b.low.y)}) {
      if (side != 0) log2_extent = std::max(log2_extent, log2_above(side));
    }
  }
  const int exponent = log2_extent == std::numeric_limits<int>::min() ? 0 : kExtentBits - log2_extent;
  make_rational_kernel(std::move(sites), operands.split, box[0].low, box[1].low, exponent,
                       operands.kernel);
  operands.bits = bits;
  operands.bounds = RoundingBounds::of(std::ldexp(1.0, kExtentBits + 2), false, false);
  operands.trace_unit = std::ldexp(1.0, -exponent);
  operands.trace_origin = {BigRational(box[0].low.x + box[1].low.x).convert_to<double>(),
                           BigRational(box[0].low.y + box[1].low.y).convert_to<double>()};
}

void approximate(Operands& operands) {
  const std::size_t n = operands.sites.x.size();
  operands.extent = {};
  for (std::size_t i = 0; i < n; ++i) {
    const auto site = static_cast<SiteId>(i);
    const Vec<double> a = operands.kernel->approximate(site);
    operands.sites.x[i] = a.x;
    operands.sites.y[i] = a.y;
    Vec<double>& extent = operands.extent[static_cast<std::size_t>(operands.operand_of(site))];
    extent = {std::max(extent.x, a.x), std::max(extent.y, a.y)};
  }
}

}  // namespace

void load_sites(const Region& p, const Region& q, const Options& options, Operands& operands) {
  const std::size_t total = p.vertex_count() + q.vertex_count();
  operands.split = static_cast<SiteId>(p.vertex_count());
  operands.sites.x.resize(total);
  operands.sites.y.resize(total);
  const Exponents common = common_exponents(p, q);
  if (common.quotients || common.bits > kMaxGridBits ||
      options.arithmetic == Arithmetic::kArbitrary) {
    load_rationals(p, q, operands);
  } else {
    load_grid(p, q, common, options, operands);
  }
  if (!options.filter) operands.bounds = RoundingBounds::distrustful(operands.bounds.magnitude);
  approximate(operands);
}

}  // namespace minksum

// Converts coordinates from an operand's own numbers to its own grid.
#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "machine/make_room.hpp"
#include "region/region_access.hpp"
#include "validation/prepared_operand.hpp"
#include "validation/rational_sites.hpp"

namespace minksum {
namespace {

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}
template <class Visit>
void for_each_coordinate(const Region& region, Cancellation& cancellation, Visit visit) {
  in_pieces(region.vertex_count(), cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      visit(RegionAccess::x(region, v));
      visit(RegionAccess::y(region, v));
    }
  });
}

/// The common scale, made of the smallest powers of two and ten in use, and the bits that it takes.
struct Scale {
  int exp2 = 0;
  int exp10 = 0;
  std::int64_t divisor = 1;
  bool quotients = false;
  bool uniform = true;  ///< all coordinates but zeros have these exponents
  int bits = 0;
};

Scale common_scale(const Region& region, Cancellation& cancellation) {
  constexpr int kHigh = std::numeric_limits<int>::max();
  int low2 = kHigh;
  int low10 = kHigh;
  int high2 = -kHigh;
  int high10 = -kHigh;
  std::uint64_t digits = 0;
  Scale scale;
  for_each_coordinate(region, cancellation, [&](const StoredCoordinate& c) {
    scale.quotients |= c.denominator_limbs != 0;
    if (c.payload == 0) return;
    low2 = std::min<int>(low2, c.exp2);
    low10 = std::min<int>(low10, c.exp10);
    high2 = std::max<int>(high2, c.exp2);
    high10 = std::max<int>(high10, c.exp10);
    digits |= magnitude(c.payload);
  });
  if (scale.quotients || low2 == kHigh) return scale;
  scale.exp2 = low2;
  scale.exp10 = low10;
  scale.uniform = low2 == high2 && low10 == high10;
  scale.bits = static_cast<int>(std::bit_width(digits)) + (high2 - low2) +
               bits_of_ten_to(high10 - low10);
  if (scale.bits <= GridCoordinates::kSmallBits) return scale;
  // The bound for all coordinates at once is too long, so each one is bounded by itself.
  scale.bits = 0;
  for_each_coordinate(region, cancellation, [&](const StoredCoordinate& c) {
    if (c.payload == 0) return;
    scale.bits = std::max(scale.bits, static_cast<int>(std::bit_width(magnitude(c.payload))) +
                                          (c.exp2 - low2) + bits_of_ten_to(c.exp10 - low10));
  });
  return scale;
}

/// The number payload · 2^exp2 · 10^exp10 / divisor.
struct LongNumber {
  Int128 payload = 0;
  int exp2 = 0;
  int exp10 = 0;
  std::int64_t divisor = 1;
};

/// Reads a coordinate. If it is stored as a quotient, its denominator without factors two and five
/// must be short.
bool as_long_number(const Region& region, const StoredCoordinate& c, LongNumber& number) {
  number = {c.payload, c.exp2, c.exp10, 1};
  if (c.denominator_limbs == 0) return true;
  const auto limbs = RegionAccess::limbs(region).subspan(static_cast<std::size_t>(c.payload));
  const std::size_t n = c.numerator_limbs & kLimbCountMask;
  const auto value = [&](std::size_t first, std::size_t count) {
    const Uint128 low = count > 0 ? limbs[first] : 0;
    return count > 1 ? low | (static_cast<Uint128>(limbs[first + 1]) << 64) : low;
  };
  if (n > 2 || c.denominator_limbs > 2) return false;
  const Uint128 above = value(0, n);
  Uint128 below = value(n, c.denominator_limbs);
  if ((above >> kMaxGridBits) != 0) return false;
  int twos = 0;
  int fives = 0;
  for (; below % 2 == 0; ++twos) below /= 2;
  for (; below % 5 == 0; ++fives) below /= 5;
  if ((below >> GridUnit::kDivisorBits) != 0) return false;
  const std::uint64_t common =
      std::gcd(static_cast<std::uint64_t>(above % below), static_cast<std::uint64_t>(below));
  number.payload = static_cast<Int128>(above / common);
  number.divisor = static_cast<std::int64_t>(below / common);
  if ((c.numerator_limbs & kNegativeLimbs) != 0) number.payload = -number.payload;
  number.exp2 += fives - twos;
  number.exp10 -= fives;
  return true;
}

template <class Number>
Number on_grid(Number value, int exp2, int exp10, const Scale& scale) {
  if (value == 0) return 0;
  for (int i = scale.exp10; i < exp10; ++i) value *= 10;
  return value * (Number{1} << (exp2 - scale.exp2));
}

/// Puts the sites on the grid, and their box at the origin. `at(v)` returns a site's place on the
/// grid.
template <class Number, class At>
void load_grid(std::size_t n, const Scale& scale, At at, Cancellation& cancellation,
               std::vector<Vec<Number>>& sites, GridCoordinates& grid) {
  sites.resize(n);
  Vec<Number> low = at(0);
  Vec<Number> high = low;
  in_pieces(n, cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      sites[v] = at(v);
      low = {std::min(low.x, sites[v].x), std::min(low.y, sites[v].y)};
      high = {std::max(high.x, sites[v].x), std::max(high.y, sites[v].y)};
    }
  });
  for (auto& s : sites) s = {s.x - low.x, s.y - low.y};
  grid.offset = {low.x, low.y};
  grid.extent = {high.x - low.x, high.y - low.y};
  grid.bits = std::max(bit_width(grid.extent.x), bit_width(grid.extent.y));
  grid.unit = {scale.exp2, scale.exp10, scale.divisor};
}

template <class Number>
void load_numbers(const Region& region, const Scale& scale, Cancellation& cancellation,
                  std::vector<Vec<Number>>& sites, GridCoordinates& grid) {
  const auto number = [&](const StoredCoordinate& c) {
    return scale.uniform ? static_cast<Number>(c.payload)
                         : on_grid<Number>(c.payload, c.exp2, c.exp10, scale);
  };
  const auto at = [&](std::size_t v) {
    return Vec<Number>{number(RegionAccess::x(region, v)), number(RegionAccess::y(region, v))};
  };
  load_grid(region.vertex_count(), scale, at, cancellation, sites, grid);
}

/// Brings all numbers to one divisor. Returns false if the divisor or a number gets too long.
bool find_common_divisor(std::vector<LongNumber>& numbers, Scale& scale) {
  for (const LongNumber& number : numbers) {
    const std::int64_t more = number.divisor / std::gcd(number.divisor, scale.divisor);
    if (more == 1) continue;
    const Int128 divisor = Int128{scale.divisor} * more;
    if (bit_width(divisor) > GridUnit::kDivisorBits) return false;
    scale.divisor = static_cast<std::int64_t>(divisor);
  }
  for (LongNumber& number : numbers) {
    const Int128 times = scale.divisor / number.divisor;
    if (times == 1) continue;
    if (bit_width(number.payload) + bit_width(times) > kMaxGridBits) return false;
    number.payload *= times;
  }
  return true;
}

/// Loads numbers of which some are stored as quotients. Returns false if they have no short common
/// denominator, or are too long.
bool load_long_numbers(const Region& region, Cancellation& cancellation, GridCoordinates& grid) {
  std::vector<LongNumber> numbers;
  bool all = true;
  for_each_coordinate(region, cancellation, [&](const StoredCoordinate& c) {
    all = all && as_long_number(region, c, numbers.emplace_back());
  });
  Scale scale;
  if (!all || !find_common_divisor(numbers, scale)) return false;
  constexpr int kHigh = std::numeric_limits<int>::max();
  scale.exp2 = scale.exp10 = kHigh;
  for (const LongNumber& number : numbers) {
    if (number.payload == 0) continue;
    scale.exp2 = std::min(scale.exp2, number.exp2);
    scale.exp10 = std::min(scale.exp10, number.exp10);
  }
  if (scale.exp2 == kHigh) scale.exp2 = scale.exp10 = 0;  // all are zero
  for (const LongNumber& number : numbers) {
    if (number.payload == 0) continue;
    scale.bits = std::max(scale.bits, bit_width(number.payload) + (number.exp2 - scale.exp2) +
                                          bits_of_ten_to(number.exp10 - scale.exp10));
  }
  if (scale.bits > kMaxGridBits) return false;
  const auto on = [&](const LongNumber& n) {
    return on_grid<Int128>(n.payload, n.exp2, n.exp10, scale);
  };
  const auto at = [&](std::size_t v) {
    return Vec<Int128>{on(numbers[2 * v]), on(numbers[2 * v + 1])};
  };
  load_grid(region.vertex_count(), scale, at, cancellation, grid.large_sites, grid);
  return true;
}

}  // namespace

Arithmetic rung_for(int bits, Arithmetic asked) {
  const Arithmetic needed = bits <= NarrowRung::kCoordinateBits   ? Arithmetic::kNarrow
                            : bits <= MediumRung::kCoordinateBits ? Arithmetic::kMedium
                                                                  : Arithmetic::kWide;
  return std::max(needed, asked);
}

void load_sites(const Region& region, const SumSettings& options, Cancellation& cancellation,
                PreparedOperand& operand) {
  operand.region = &region;
  operand.thin = false;
  GridCoordinates& grid = operand.grid;
  const Scale scale = common_scale(region, cancellation);
  const bool rationals_asked = options.arithmetic == Arithmetic::kArbitrary;
  // Sums and differences of two small numbers have one bit more, and need a sign.
  grid.small = !scale.quotients && scale.bits < GridCoordinates::kSmallBits;
  if (!rationals_asked && scale.quotients && load_long_numbers(region, cancellation, grid)) {
    operand.rational = false;
    return;
  }
  operand.rational = rationals_asked || scale.quotients || scale.bits > kMaxGridBits;
  if (operand.rational) {
    load_rationals(region, cancellation, operand.rationals);
  } else if (grid.small) {
    load_numbers(region, scale, cancellation, grid.small_sites, grid);
  } else {
    load_numbers(region, scale, cancellation, grid.large_sites, grid);
  }
}

}  // namespace minksum

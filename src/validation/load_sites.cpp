// Converts coordinates from an operand's own numbers to its own grid.
#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>

#include "region/grid_scale.hpp"
#include "validation/prepared_operand.hpp"
#include "validation/rational_sites.hpp"

namespace minksum {
namespace {

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
  const auto low = static_cast<std::uint64_t>(below);
  const int twos = low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(limbs[n + 1]);
  below >>= twos;
  int fives = 0;
  for (; (below >> 64) != 0 && below % 5 == 0; ++fives) below /= 5;
  if ((below >> 64) != 0) return false;
  auto rest = static_cast<std::uint64_t>(below);
  for (; rest % 5 == 0; ++fives) rest /= 5;
  if ((rest >> GridUnit::kDivisorBits) != 0) return false;
  const std::uint64_t common =
      rest == 1 ? 1 : std::gcd(static_cast<std::uint64_t>(above % rest), rest);
  number.payload = static_cast<Int128>(common == 1 ? above : above / common);
  number.divisor = static_cast<std::int64_t>(rest / common);
  if ((c.numerator_limbs & kNegativeLimbs) != 0) number.payload = -number.payload;
  number.exp2 += fives - twos;
  number.exp10 -= fives;
  return true;
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
bool find_common_divisor(std::vector<LongNumber>& numbers, std::int64_t& divisor) {
  for (const LongNumber& number : numbers) {
    const std::int64_t more = number.divisor / std::gcd(number.divisor, divisor);
    if (more == 1) continue;
    const Int128 both = Int128{divisor} * more;
    if (bit_width(both) > GridUnit::kDivisorBits) return false;
    divisor = static_cast<std::int64_t>(both);
  }
  for (LongNumber& number : numbers) {
    const Int128 times = divisor / number.divisor;
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
  std::int64_t divisor = 1;
  if (!all || !find_common_divisor(numbers, divisor)) return false;
  Scale scale = scale_of([&](auto visit) {
    for (const LongNumber& number : numbers) visit(number.payload, number.exp2, number.exp10);
  });
  scale.divisor = divisor;
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
  const std::optional<Scale> scale =
      scale_of_stored([&](auto visit) { for_each_coordinate(region, cancellation, visit); });
  const bool rationals_asked = options.arithmetic == Arithmetic::kArbitrary;
  // Sums and differences of two small numbers have one bit more, and need a sign.
  grid.small = scale && scale->bits < GridCoordinates::kSmallBits;
  operand.rational = rationals_asked || (scale ? scale->bits > kMaxGridBits
                                               : !load_long_numbers(region, cancellation, grid));
  if (operand.rational) {
    load_rationals(region, cancellation, operand.rationals);
  } else if (grid.small) {
    load_numbers(region, *scale, cancellation, grid.small_sites, grid);
  } else if (scale) {
    load_numbers(region, *scale, cancellation, grid.large_sites, grid);
  }
}

}  // namespace minksum

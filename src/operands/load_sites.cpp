// Coordinates from an operand's own numbers to its own grid.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "operands/prepared_operand.hpp"
#include "operands/rational_sites.hpp"
#include "region/region_access.hpp"

namespace minksum {
namespace {

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}
int bit_width(Int128 value) {
  const auto high = static_cast<std::uint64_t>(static_cast<Uint128>(value) >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

template <class Visit>
void for_each_coordinate(const Region& region, Visit visit) {
  const std::size_t n = region.vertex_count();
  for (std::size_t v = 0; v < n; ++v) {
    visit(RegionAccess::x(region, v));
    visit(RegionAccess::y(region, v));
  }
}

/// The common scale: the smallest powers of two and ten in use. And the bits that it takes.
struct Scale {
  int exp2 = 0;
  int exp10 = 0;
  bool quotients = false;
  bool uniform = true;  ///< all coordinates but zeros have these exponents
  int bits = 0;
};

Scale common_scale(const Region& region) {
  constexpr int kHigh = std::numeric_limits<int>::max();
  int low2 = kHigh;
  int low10 = kHigh;
  int high2 = -kHigh;
  int high10 = -kHigh;
  std::uint64_t digits = 0;
  Scale scale;
  for_each_coordinate(region, [&](const StoredCoordinate& c) {
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
  // No such bound for all: one for each.
  scale.bits = 0;
  for_each_coordinate(region, [&](const StoredCoordinate& c) {
    if (c.payload == 0) return;
    scale.bits = std::max(scale.bits, static_cast<int>(std::bit_width(magnitude(c.payload))) +
                                          (c.exp2 - low2) + bits_of_ten_to(c.exp10 - low10));
  });
  return scale;
}

template <class Number>
Number on_grid(const StoredCoordinate& c, const Scale& scale) {
  if (c.payload == 0) return 0;
  Number value = c.payload;
  for (int i = scale.exp10; i < c.exp10; ++i) value *= 10;
  return value * (Number{1} << (c.exp2 - scale.exp2));
}

/// Puts the sites on the grid, their box at the origin.
template <class Number>
void load_grid(const Region& region, const Scale& scale, std::vector<Vec<Number>>& sites,
               GridCoordinates& grid) {
  const std::size_t n = region.vertex_count();
  sites.resize(n);
  const auto number = [&](const StoredCoordinate& c) {
    return scale.uniform ? static_cast<Number>(c.payload) : on_grid<Number>(c, scale);
  };
  Vec<Number> low{number(RegionAccess::x(region, 0)), number(RegionAccess::y(region, 0))};
  Vec<Number> high = low;
  for (std::size_t v = 0; v < n; ++v) {
    const Vec<Number> at{number(RegionAccess::x(region, v)), number(RegionAccess::y(region, v))};
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    sites[v] = at;
  }
  for (auto& s : sites) s = {s.x - low.x, s.y - low.y};
  grid.offset = {low.x, low.y};
  grid.extent = {high.x - low.x, high.y - low.y};
  grid.bits = std::max(bit_width(grid.extent.x), bit_width(grid.extent.y));
  grid.exp2 = scale.exp2;
  grid.exp10 = scale.exp10;
}

}  // namespace

Arithmetic rung_for(int bits, Arithmetic asked) {
  const Arithmetic needed = bits <= NarrowRung::kCoordinateBits   ? Arithmetic::kNarrow
                            : bits <= MediumRung::kCoordinateBits ? Arithmetic::kMedium
                                                                  : Arithmetic::kWide;
  return std::max(needed, asked);
}

void load_sites(const Region& region, const Options& options, PreparedOperand& operand) {
  operand.region = &region;
  const Scale scale = common_scale(region);
  GridCoordinates& grid = operand.grid;
  operand.rational = scale.quotients || scale.bits > kMaxGridBits ||
                     options.arithmetic == Arithmetic::kArbitrary;
  // A sum or difference of two such has one bit more, and must have its sign.
  grid.small = scale.bits < GridCoordinates::kSmallBits;
  if (operand.rational) {
    load_rationals(region, operand.rationals);
  } else if (grid.small) {
    load_grid(region, scale, grid.small_sites, grid);
  } else {
    load_grid(region, scale, grid.large_sites, grid);
  }
}

}  // namespace minksum

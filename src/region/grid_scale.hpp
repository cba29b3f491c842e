// Finds the integer grid on which numbers lie, and puts them on it.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

#include "exact/exact_kernel.hpp"
#include "machine/make_room.hpp"
#include "region/region_access.hpp"

namespace minksum {

/// A scale made of the smallest powers of two and ten in use, and the bits that it takes.
struct Scale {
  int exp2 = 0;
  int exp10 = 0;
  std::int64_t divisor = 1;
  bool uniform = true;  ///< all numbers but zeros have these exponents
  int bits = 0;
};

template <class Integer>
[[nodiscard]] auto magnitude(Integer value) {
  using Unsigned = std::conditional_t<sizeof value == sizeof(Uint128), Uint128, std::uint64_t>;
  const auto bits = static_cast<Unsigned>(value);
  return value < 0 ? Unsigned{0} - bits : bits;
}

/// Returns the scale of numbers payload · 2^exp2 · 10^exp10. for_each(visit) calls visit(payload,
/// exp2, exp10) for each of them, and may be called twice.
template <class ForEach>
Scale scale_of(ForEach for_each) {
  constexpr int kHigh = std::numeric_limits<int>::max();
  Scale low{kHigh, kHigh};
  Scale high{-kHigh, -kHigh};
  Uint128 digits = 0;
  for_each([&](auto payload, int exp2, int exp10) {
    if (payload == 0) return;
    low.exp2 = std::min(low.exp2, exp2);
    low.exp10 = std::min(low.exp10, exp10);
    high.exp2 = std::max(high.exp2, exp2);
    high.exp10 = std::max(high.exp10, exp10);
    digits |= magnitude(payload);
  });
  if (digits == 0) return {};
  low.uniform = low.exp2 == high.exp2 && low.exp10 == high.exp10;
  low.bits = bit_width(static_cast<Int128>(digits)) + (high.exp2 - low.exp2) +
             bits_of_ten_to(high.exp10 - low.exp10);
  if (low.bits <= GridCoordinates::kSmallBits) return low;
  // The bound for all numbers at once is too long, so each one is bounded by itself.
  low.bits = 0;
  for_each([&](Int128 payload, int exp2, int exp10) {
    if (payload == 0) return;
    low.bits = std::max(low.bits,
                        bit_width(payload) + (exp2 - low.exp2) + bits_of_ten_to(exp10 - low.exp10));
  });
  return low;
}

/// Returns the scale of stored coordinates, which for_each(visit) visits. Returns nothing if one is
/// stored as a quotient.
template <class ForEach>
std::optional<Scale> scale_of_stored(ForEach for_each) {
  bool quotients = false;
  const Scale scale = scale_of([&](auto visit) {
    if (quotients) return;
    for_each([&](const StoredCoordinate& c) {
      quotients |= c.denominator_limbs != 0;
      visit(c.payload, c.exp2, c.exp10);
    });
  });
  return quotients ? std::nullopt : std::optional(scale);
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

template <class Number>
Number on_grid(Number value, int exp2, int exp10, const Scale& scale) {
  // The exponents of zero are of no matter.
  return value == 0 ? 0 : scaled(value, exp2 - scale.exp2, exp10 - scale.exp10);
}

/// Puts the sites on the grid, and their box at the origin. `at(v)` returns a site's place on the
/// grid.
template <class Number, class At>
void load_grid(std::size_t n, const Scale& scale, At at, Cancellation& cancellation,
               std::vector<Vec<Number>>& sites, GridCoordinates& grid) {
  sites.resize(n);
  Vec<Number> low = n == 0 ? Vec<Number>{0, 0} : at(0);
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

}  // namespace minksum

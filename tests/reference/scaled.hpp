// Brings operands of the reference to one integer grid, and defines quotients on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/convex_pieces.hpp"
#include "reference/exact.hpp"

namespace minksum::reference {

/// A quotient with a positive denominator.
template <class Int>
struct Fraction {
  Int n;
  Int d;
  friend bool operator<(const Fraction& a, const Fraction& b) { return a.n * b.d < b.n * a.d; }
};

template <class Int>
struct Interval {
  Fraction<Int> low;
  Fraction<Int> high;
};

/// Both operands on one integer grid, where coordinate = integer / scale. Thin parts are loops of
/// the two ends of a segment, or of one point.
struct Scaled {
  Loops p;
  Loops q;
  Loops thin_p;
  Loops thin_q;
  Integer scale = 1;
  std::size_t bits = 0;
};

/// Returns both operands on the coarsest grid that holds them.
[[nodiscard]] Scaled scale_up(const Region& p, const Region& q, Loops thin_p = {},
                              Loops thin_q = {});

/// Returns the same integer, of any size.
template <class Int>
[[nodiscard]] Integer to_integer(const Int& value) {
  if constexpr (std::is_same_v<Int, Int128>) {
    return (Integer(static_cast<std::int64_t>(value >> 64)) << 64) +
           static_cast<std::uint64_t>(value);
  } else {
    return Integer(value);
  }
}
/// Returns the same integer, which must fit.
template <class Int>
[[nodiscard]] Int to_int(const Integer& value) {
  if constexpr (std::is_same_v<Int, Int128>) {
    // Shifting rounds down, so the rest is not negative.
    const Integer high(value >> 64);
    return (static_cast<Int128>(high.convert_to<std::int64_t>()) << 64) +
           Integer(value - (high << 64)).convert_to<std::uint64_t>();
  } else {
    return value.convert_to<Int>();
  }
}

/// Returns loops whose coordinates are integers.
template <class Int>
[[nodiscard]] std::vector<IntLoop<Int>> to_int(const Loops& loops) {
  std::vector<IntLoop<Int>> result;
  for (const Loop& loop : loops) {
    IntLoop<Int> ring;
    for (const Pt& p : loop) {
      ring.push_back({to_int<Int>(numerator(p.x)), to_int<Int>(numerator(p.y))});
    }
    result.push_back(std::move(ring));
  }
  return result;
}

}  // namespace minksum::reference

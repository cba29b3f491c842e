// Brings operands of the reference to one integer grid, and defines quotients on it.
#pragma once

#include <cstddef>
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

/// Returns loops whose coordinates are integers.
template <class Int>
[[nodiscard]] std::vector<IntLoop<Int>> to_int(const Loops& loops) {
  std::vector<IntLoop<Int>> result;
  for (const Loop& loop : loops) {
    IntLoop<Int> ring;
    for (const Pt& p : loop) {
      ring.push_back({numerator(p.x).convert_to<Int>(), numerator(p.y).convert_to<Int>()});
    }
    result.push_back(std::move(ring));
  }
  return result;
}

}  // namespace minksum::reference

// Multiples of a power of ten: coordinates with few digits.
#pragma once

#include <cmath>

#include "minksum/rational.hpp"

namespace minksum {

class DecimalGrid {
 public:
  /// The step is the largest power of ten that is not above `bound`, which is positive.
  static DecimalGrid below(const Rational& bound) {
    const auto bits = [](const Rational& integer) { return static_cast<double>(integer.bits()); };
    // Its logarithm to base 10, at most 1 too large, and at most 1 too small.
    const double log2 = bits(bound.numerator()) - bits(bound.denominator());
    DecimalGrid grid(static_cast<int>(std::floor((log2 + 1) * 0.30103)) + 1);
    while (bound < grid.step_) grid = DecimalGrid(grid.exponent_ - 1);
    return grid;
  }

  [[nodiscard]] const Rational& step() const { return step_; }
  /// So many steps, to the nearest; the double must be below 2^63.
  [[nodiscard]] Rational at(double steps) const {
    return Rational(Decimal{static_cast<std::int64_t>(std::llround(steps)), exponent_});
  }

 private:
  explicit DecimalGrid(int exponent) : exponent_(exponent), step_(Rational(Decimal{1, exponent})) {}

  int exponent_;
  Rational step_;
};

}  // namespace minksum

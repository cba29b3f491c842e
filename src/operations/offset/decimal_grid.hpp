// Makes multiples of a power of ten, which are coordinates with few digits.
#pragma once

#include <cmath>

#include "minksum/rational.hpp"

namespace minksum {

class DecimalGrid {
 public:
  /// Returns the grid whose step is the largest power of ten up to `bound`, which is positive.
  static DecimalGrid below(const Rational& bound) {
    const auto bits = [](const Rational& integer) { return static_cast<double>(integer.bits()); };
    // This logarithm is at most 1 too large and at most 1 too small, so the first exponent is not
    // too low.
    const double log2 = bits(bound.numerator()) - bits(bound.denominator());
    DecimalGrid grid(static_cast<int>(std::floor((log2 + 1) * 0.30103)) + 1);
    while (bound < grid.step_) grid = DecimalGrid(grid.exponent_ - 1);
    return grid;
  }

  [[nodiscard]] const Rational& step() const { return step_; }
  /// Returns the nearest multiple of the step to so many steps. The double must be below 2^63.
  [[nodiscard]] Rational at(double steps) const {
    return Rational(Decimal{static_cast<std::int64_t>(std::llround(steps)), exponent_});
  }

 private:
  explicit DecimalGrid(int exponent) : exponent_(exponent), step_(Rational(Decimal{1, exponent})) {}

  int exponent_;
  Rational step_;
};

}  // namespace minksum

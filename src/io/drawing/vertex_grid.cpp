#include "io/drawing/vertex_grid.hpp"

#include <cmath>

#include "minksum/error.hpp"

namespace minksum::io {

void fail_too_small_tolerance() {
  throw Error(ErrorCode::kLimitExceeded,
              "the tolerance is too small for this curve beside its coordinates, which are proved "
              "in doubles");
}

VertexGrid::VertexGrid(const Rational& tolerance) {
  const Rational bound = tolerance / Rational(256);
  const auto bits = [](const Rational& integer) { return static_cast<double>(integer.bits()); };
  // This logarithm is at most 1 off.
  const double log2 = bits(bound.numerator()) - bits(bound.denominator());
  exponent_ = static_cast<int>(std::floor((log2 + 1) * 0.30103)) + 1;
  const auto power = [](int exponent) { return Rational(Decimal{1, exponent}); };
  while (bound < power(exponent_)) --exponent_;
  step_ = power(exponent_);
  size_ = step_.to_double();
  if (!(size_ > 1e-200 && size_ < 1e200)) fail_too_small_tolerance();
}

Rational VertexGrid::at(double steps) const {
  constexpr double kMost = 0x1p50;
  if (!(std::abs(steps) < kMost)) fail_too_small_tolerance();
  return Rational(Decimal{static_cast<std::int64_t>(std::llround(steps)), exponent_});
}

Rational VertexGrid::near(const Rational& value) const { return at((value / step_).to_double()); }

GridView::GridView(const VertexGrid& grid, const Point& origin)
    : grid_(grid), x_(grid, origin.x), y_(grid, origin.y) {}

GridView::Axis::Axis(const VertexGrid& grid, const Rational& at) : origin(at) {
  const Rational steps = at / grid.step();
  whole = std::floor(steps.to_double());
  rest = std::isfinite(whole) ? (steps - Rational(whole)).to_double() : HUGE_VAL;
}

Rational GridView::near(const Axis& axis, double offset) const {
  if (!std::isfinite(offset)) fail_too_small_tolerance();
  const double moved = axis.rest + offset / grid_.size();
  const double steps = std::round(moved);
  // Doubles tell the same as the exact sum, unless that is about in the middle of two steps.
  const double doubt = 0x1p-50 * (std::abs(axis.whole) + std::abs(moved) + 2);
  if (std::abs(moved - steps) + doubt < 0.5) return grid_.at(axis.whole + steps);
  return grid_.near(axis.origin + Rational(offset));
}

}  // namespace minksum::io

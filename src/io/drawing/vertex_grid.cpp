#include "io/drawing/vertex_grid.hpp"

#include <cmath>

#include "minksum/error.hpp"

namespace minksum::io {
namespace {

/// Returns a number of steps. Below this bound, doubles hold every whole number and its sums.
double checked(double steps) {
  constexpr double kMost = 0x1p50;
  if (!(std::abs(steps) < kMost)) fail_too_small_tolerance();
  return steps;
}

}  // namespace

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

double VertexGrid::steps_near(const Rational& value) const {
  return checked(std::round((value / step_).to_double()));
}

Rational VertexGrid::at(double steps) const {
  return Rational(Decimal{static_cast<std::int64_t>(steps), exponent_});
}

bool VertexGrid::has_diagonal_within(const GridBox& box, double length) const {
  const Point diagonal = at({box.high.x - box.low.x, box.high.y - box.low.y});
  const Rational most(length);
  return diagonal.x * diagonal.x + diagonal.y * diagonal.y <= most * most;
}

GridView::GridView(const VertexGrid& grid, const Point& origin)
    : grid_(grid), step_(Interval::of(grid.step())), x_(grid, origin.x), y_(grid, origin.y) {}

GridView::Axis::Axis(const VertexGrid& grid, const Rational& at) : origin(at) {
  const Rational steps = at / grid.step();
  whole = std::floor(steps.to_double());
  if (std::isfinite(whole)) rest = Interval::of(steps - Rational(whole));
}

GridBox GridView::around(const Hull& hull) const {
  const double step = grid_.size();
  return {near(hull.low_x - step, hull.low_y - step), near(hull.high_x + step, hull.high_y + step)};
}

double GridView::near(const Axis& axis, double offset) const {
  if (!std::isfinite(offset)) fail_too_small_tolerance();
  const double moved = axis.rest.middle() + offset / grid_.size();
  const double steps = std::round(moved);
  // Doubles tell the same as the exact sum, unless that is about in the middle of two steps.
  const double doubt = 0x1p-50 * (std::abs(axis.whole) + std::abs(moved) + 2);
  if (std::abs(moved - steps) + doubt < 0.5) return checked(axis.whole + steps);
  return grid_.steps_near(axis.origin + Rational(offset));
}

}  // namespace minksum::io

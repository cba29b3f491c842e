#include "turns.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace minksum::cli {
namespace {

// The first convergent of the continued fraction of `value` that is closer than this: its numerator
// and denominator are about as small as can be.
Rational near(double value) {
  constexpr double kClose = 2.5e-6;
  std::int64_t p0 = 0;
  std::int64_t q0 = 1;
  std::int64_t p1 = 1;
  std::int64_t q1 = 0;
  for (double rest = value;;) {
    const double whole = std::floor(rest);
    const auto digit = static_cast<std::int64_t>(whole);
    p0 = std::exchange(p1, digit * p1 + p0);
    q0 = std::exchange(q1, digit * q1 + q0);
    if (std::fabs(static_cast<double>(p1) / static_cast<double>(q1) - value) < kClose) break;
    rest = 1 / (rest - whole);
  }
  return {p1, q1};
}

}  // namespace

// Quarters apart from the rest, so that the tangent is at most 1. An error of the tangent of half
// an angle is at most twice as large in the angle.
Turn turn_by(int k, int rotations) {
  const int quarters = static_cast<int>(std::int64_t{4} * k / rotations);
  const std::int64_t rest = std::int64_t{4} * k - std::int64_t{quarters} * rotations;
  if (rest == 0) return {Affine::quarter_turns(quarters), {}};
  const double angle = std::numbers::pi / 2 * static_cast<double>(rest) / rotations;
  const Rational small = near(std::tan(angle / 2));
  Turn turn{Affine::quarter_turns(quarters).after(Affine::rotation(small)), {}};
  // The tangent of a sum, quarter by quarter of which the half is 45 degrees.
  Rational half = small;
  for (int i = 0; i < quarters; ++i) half = (half + 1) / (Rational(1) - half);
  turn.half = half;
  return turn;
}

}  // namespace minksum::cli

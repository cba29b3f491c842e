// Turns angles into rational points of the unit circle.
#include <cmath>
#include <numbers>
#include <utility>

#include "machine/bad_input.hpp"
#include "minksum/configuration_space.hpp"

namespace minksum {
namespace {

constexpr double kMostDegrees = 1e6;
/// Exceeds the rounding errors below: doubles up to 90 have steps below 2e-14.
constexpr double kRounding = 1e-12;

/// Returns the fraction of smallest denominator in [low, high], 0 ≤ low < high, up to rounding.
std::pair<std::int64_t, std::int64_t> simplest_between(double low, double high) {
  const double whole = std::floor(low);
  const auto integer = static_cast<std::int64_t>(whole);
  if (whole == low) return {integer, 1};
  if (whole + 1 <= high) return {integer + 1, 1};
  const auto [p, q] = simplest_between(1 / (high - whole), 1 / (low - whole));
  return {integer * p + q, p};
}

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

/// Sets the turn for a rest of more than 0 and less than 90 degrees.
void approximate(double rest, double tolerance, Turn& turn) {
  // Rounding may put the fraction just beyond the ends. Then a closer one is tried.
  for (double within = tolerance - kRounding; within > tolerance / 16; within /= 2) {
    const double low = rest > within ? std::tan(radians(rest - within) / 2) : 0;
    const double high = std::tan(radians(rest + within) / 2);
    const auto [p, q] = simplest_between(low, high);
    const bool quarter = p >= q;
    turn.tan_half = quarter ? Rational(0) : Rational(p, q);
    turn.degrees = 90;
    if (!quarter) {
      turn.degrees = 2 * std::atan(turn.tan_half.to_double()) * (180 / std::numbers::pi);
    }
    turn.off = std::abs(turn.degrees - rest) + kRounding;
    if (turn.off > tolerance) continue;
    turn.quarters += quarter ? 1 : 0;
    return;
  }
  throw Error(ErrorCode::kInternal, "no turn near an angle", {}, "turn");
}

}  // namespace

Affine Turn::map() const {
  return Affine::quarter_turns(quarters).after(Affine::rotation(tan_half));
}

Point Turn::direction() const { return map()({Rational(1), Rational(0)}); }

Turn nearest_turn(const Rational& degrees, double tolerance) {
  if (!(tolerance >= 1e-10 && tolerance <= 1)) {
    refuse_input("a turn's tolerance must be from 1e-10 to 1 degrees");
  }
  const double about = degrees.to_double();
  if (!(std::abs(about) <= kMostDegrees)) {
    refuse_input("an angle must not be beyond a million degrees");
  }
  auto quarters = static_cast<std::int64_t>(std::floor(about / 90));
  Rational rest = degrees - Rational(90 * quarters);
  for (; rest.sign() < 0; --quarters) rest = rest + Rational(90);
  for (; rest >= Rational(90); ++quarters) rest = rest - Rational(90);
  Turn turn;
  turn.asked = degrees;
  if (rest.sign() > 0) approximate(rest.to_double(), tolerance, turn);
  turn.quarters = static_cast<int>((((quarters + turn.quarters) % 4) + 4) % 4);
  turn.degrees += 90 * static_cast<double>(quarters);
  return turn;
}

std::vector<Turn> full_turn(std::size_t n, double tolerance) {
  if (n == 0) refuse_input("a full turn needs at least one angle");
  // Each turn makes a slice. By this limit a mistaken number does not exhaust memory.
  constexpr std::size_t kMostTurns = 1'000'000;
  if (n > kMostTurns) {
    throw Error(ErrorCode::kLimitExceeded, "a full turn in more than 1000000 steps");
  }
  std::vector<Turn> turns;
  turns.reserve(n);
  const Rational step = Rational(360) / Rational(static_cast<std::int64_t>(n));
  for (std::size_t i = 0; i < n; ++i) {
    turns.push_back(nearest_turn(Rational(static_cast<std::int64_t>(i)) * step, tolerance));
  }
  return turns;
}

}  // namespace minksum

#include "options/turns.hpp"

#include <cstdint>

#include "minksum/configuration_space.hpp"

namespace minksum::cli {

PartialTurn turn_by(int k, int rotations) {
  constexpr double kDegrees = 5e-4;  // less than 10^-5 radians
  const auto nearest = nearest_turn(Rational(std::int64_t{360} * k, rotations), kDegrees);
  PartialTurn turn{nearest.map(), {}};
  if (std::int64_t{4} * k % rotations == 0) return turn;
  // Each quarter turn adds 45 degrees to half the angle; the tangent follows by its sum formula.
  Rational half = nearest.tan_half;
  for (int i = 0; i < nearest.quarters; ++i) half = (half + 1) / (Rational(1) - half);
  turn.half = half;
  return turn;
}

}  // namespace minksum::cli

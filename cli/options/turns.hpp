// Parts of a full turn as exact rotations.
#pragma once

#include <optional>

#include "minksum/transform.hpp"

namespace minksum::cli {

/// A rotation by an angle whose half has a rational tangent.
struct Turn {
  Affine map;
  /// The tangent of half the angle; none for multiples of 90 degrees, which are exact.
  std::optional<Rational> half;
};

/// Counter-clockwise by about k/R of a full turn (0 ≤ k < R): exactly, if that is a multiple of 90
/// degrees; else by less than 10^-5 radians more or less, and `half` says exactly by how much.
[[nodiscard]] Turn turn_by(int k, int rotations);

}  // namespace minksum::cli

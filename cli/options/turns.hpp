// Makes exact rotations of parts of a full turn.
#pragma once

#include <optional>

#include "minksum/transform.hpp"

namespace minksum::cli {

/// A rotation by an angle whose half has a rational tangent.
struct PartialTurn {
  Affine map;
  /// The tangent of half the angle; none for multiples of 90 degrees, whose rotations are exact.
  std::optional<Rational> half;
};

/// Returns a counter-clockwise rotation by about k/R of a full turn, for 0 ≤ k < R. Multiples of 90
/// degrees are exact. Others are off by less than 10^-5 radians, and `half` gives the exact angle.
[[nodiscard]] PartialTurn turn_by(int k, int rotations);

}  // namespace minksum::cli

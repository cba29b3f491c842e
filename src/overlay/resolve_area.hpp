// What an operand covers.
#pragma once

#include "minksum/resolve.hpp"

namespace minksum {

/// Tells whether rings mean what they are, outer or a hole, and their orientation means nothing.
[[nodiscard]] constexpr bool is_by_role(FillRule fill) {
  return fill == FillRule::kAutomatic || fill == FillRule::kStrict;
}

/// As `resolve`, without thin parts whatever the options say. An error names this operand.
[[nodiscard]] inline Geometry resolve_area(const Geometry& geometry, int operand,
                                           const Options& options) {
  Options areal = options;
  areal.regularize = true;
  return resolve(geometry, areal, operand);
}

}  // namespace minksum

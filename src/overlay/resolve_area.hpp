// What an operand means.
#pragma once

#include "minksum/resolve.hpp"
#include "minksum/validity.hpp"

namespace minksum {

/// Tells whether rings mean what they are, outer or a hole, and their orientation means nothing.
[[nodiscard]] constexpr bool is_by_role(FillRule fill) {
  return fill == FillRule::kAutomatic || fill == FillRule::kStrict;
}

/// Tells whether a geometry is a valid region alone that means what it is. That takes a quarter of
/// the time of `resolve`. Its rings may have any direction.
[[nodiscard]] inline bool is_plain(const Geometry& geometry, const Options& options) {
  return !geometry.has_thin_parts() && is_by_role(options.fill) &&
         validate(geometry.region, 1, options).empty();
}
/// As `resolve`, but a geometry that is plain stays as it is.
[[nodiscard]] inline Geometry read_operand(const Geometry& geometry, int operand,
                                           const Options& options) {
  return is_plain(geometry, options) ? geometry : resolve(geometry, options, operand);
}

/// As `resolve`, without thin parts whatever the options say. An error names this operand.
[[nodiscard]] inline Geometry resolve_area(const Geometry& geometry, int operand,
                                           const Options& options) {
  Options areal = options;
  areal.regularize = true;
  return resolve(geometry, areal, operand);
}

}  // namespace minksum

// Defines what the tests of offsets share.
#pragma once

#include <array>
#include <string>

#include "minksum/offset.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/rounding_options.hpp"
#include "support/shapes.hpp"

namespace minksum::test {

inline constexpr int kShapes = 60;
inline constexpr std::array kJoins = {Join::kRound, Join::kMiter, Join::kSquare, Join::kBevel};
inline constexpr std::array kCaps = {Cap::kRound, Cap::kButt, Cap::kSquare};

[[nodiscard]] inline Geometry of_area(const Region& region) { return {region, {}, {}}; }

[[nodiscard]] inline OffsetOptions round_to(RoundingSide side, const Rational& tolerance) {
  OffsetOptions options;
  options.side = side;
  options.tolerance = tolerance;
  return options;
}
[[nodiscard]] inline OffsetOptions with(Join join, Cap cap = Cap::kRound) {
  OffsetOptions options;
  options.join = join;
  options.cap = cap;
  return options;
}

[[nodiscard]] inline std::string message(const Geometry& a, const Rational& d) {
  return to_text(a) + "\ndistance " + d.to_string();
}

}  // namespace minksum::test

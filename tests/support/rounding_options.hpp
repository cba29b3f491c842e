// Makes options for rounding, and a small region that has to be rounded.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "minksum/round.hpp"

namespace minksum::test {

inline constexpr std::array kRoundingSides{RoundingSide::kNearest, RoundingSide::kOutside,
                                           RoundingSide::kInside};

inline RoundOptions rounding(std::optional<int> decimals, RoundingSide side) {
  RoundOptions options;
  options.decimals = decimals;
  options.side = side;
  return options;
}
inline RoundOptions to_decimals(int digits, RoundingSide side = RoundingSide::kNearest) {
  return rounding(digits, side);
}
/// The rounded set, and its report.
inline Region round(const Region& region, const RoundOptions& target, RoundingReport& report) {
  Rounded rounded = detailed_round(region, target);
  report = rounded.report;
  return std::move(rounded.geometry.region);
}
inline Geometry round(const Geometry& geometry, const RoundOptions& target,
                      RoundingReport& report) {
  Rounded rounded = detailed_round(geometry, target);
  report = rounded.report;
  return std::move(rounded.geometry);
}
inline RoundOptions to_doubles(RoundingSide side) { return rounding({}, side); }

inline Point point(const char* x, const char* y) {
  return {*Rational::parse(x), *Rational::parse(y)};
}

inline Region third_triangle() {
  return Region(Polygon{{point("0", "0"), point("1/3", "0"), point("0", "2/3")}, {}});
}

}  // namespace minksum::test

// Declares how pieces of outlines are joined at their ends.
#pragma once

#include <cstddef>
#include <vector>

#include "io/drawing/outlines.hpp"

namespace minksum::io {

/// What joining has found.
struct Joined {
  std::size_t open = 0;      ///< outlines that are not closed
  std::size_t repeated = 0;  ///< pieces that are drawn more than once, and count once
};

/// Joins open chains where ends are equal, and then those whose ends are at most `distance` apart,
/// by straight pieces. Adds what is closed as rings, and the rest as polylines. Chains go on
/// through points at which an even number of ends meet; by the even-odd rule it does not matter
/// how. They end where an odd number does. Throws Error(kLimitExceeded) if a distance is so large
/// that more than eight ends are near one.
Joined add_joined(std::vector<Chain> open, std::vector<Chain> closed, const Rational& distance,
                  Outlines& outlines);

}  // namespace minksum::io

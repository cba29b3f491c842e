// Finds round numbers for the axes of a picture.
#pragma once

#include <string>
#include <vector>

namespace minksum::cli {

/// One mark of an axis.
struct Tick {
  double value;
  std::string label;
};

/// Returns marks from `low` to `high`, at multiples of the smallest of ..., 0.5, 1, 2, 5, 10, ...
/// that is `apart` or more. Returns none where doubles are too coarse to tell marks apart.
[[nodiscard]] std::vector<Tick> ticks_between(double low, double high, double apart);

}  // namespace minksum::cli

// Round numbers along the sides of a picture.
#pragma once

#include <string>
#include <vector>

namespace minksum::cli {

/// One mark of an axis.
struct Tick {
  double value;
  std::string label;
};

/// Marks at multiples of the smallest of 1, 2, 5, 10, 20, ... (and 0.5, 0.2, ...) that is `apart`
/// or more, from `low` to `high`. None where doubles are too coarse to tell them from each other.
[[nodiscard]] std::vector<Tick> ticks_between(double low, double high, double apart);

}  // namespace minksum::cli

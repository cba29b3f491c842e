// The order of exact points: by x, then by y.
#pragma once

#include "minksum/region.hpp"

namespace minksum {

[[nodiscard]] inline bool comes_before(const Point& a, const Point& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

}  // namespace minksum

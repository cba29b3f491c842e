// A shape with holes for tests of small operands and sums.
#pragma once

#include <vector>

#include "support/shapes.hpp"

namespace minksum::test {

/// Returns a square of width 9 at the origin with these holes.
inline Region with_holes(const std::vector<Outline>& holes) {
  return make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, holes);
}

}  // namespace minksum::test

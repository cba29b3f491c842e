// Defines the order of exact points, and arithmetic with them as vectors.
#pragma once

#include "minksum/region.hpp"

namespace minksum {

/// Orders points by x, then by y.
[[nodiscard]] inline bool comes_before(const Point& a, const Point& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

[[nodiscard]] inline Point plus(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Rational dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline Rational cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace minksum

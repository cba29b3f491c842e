// Defines boxes over any number type.
#pragma once

#include <algorithm>

#include "exact/axis.hpp"

namespace minksum {

/// A closed box over any number type, with sides parallel to the axes.
template <class Number>
struct BoxOf {
  Number x0, y0, x1, y1;

  [[nodiscard]] constexpr Number& low(Axis axis) { return axis == Axis::kX ? x0 : y0; }
  [[nodiscard]] constexpr Number& high(Axis axis) { return axis == Axis::kX ? x1 : y1; }
  [[nodiscard]] constexpr const Number& low(Axis axis) const { return axis == Axis::kX ? x0 : y0; }
  [[nodiscard]] constexpr const Number& high(Axis axis) const { return axis == Axis::kX ? x1 : y1; }
  [[nodiscard]] Axis longer() const { return x1 - x0 >= y1 - y0 ? Axis::kX : Axis::kY; }

  void add(const BoxOf& other) {
    x0 = std::min(x0, other.x0);
    y0 = std::min(y0, other.y0);
    x1 = std::max(x1, other.x1);
    y1 = std::max(y1, other.y1);
  }
  [[nodiscard]] bool meets(const BoxOf& other) const {
    return (x0 <= other.x1) & (other.x0 <= x1) & (y0 <= other.y1) & (other.y0 <= y1);
  }
};

}  // namespace minksum

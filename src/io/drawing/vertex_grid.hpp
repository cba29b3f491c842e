// Declares the grid on which vertices of curves lie, and rounds points to it.
#pragma once

#include <algorithm>
#include <cmath>

#include "io/drawing/curve.hpp"
#include "minksum/region.hpp"

namespace minksum::io {

/// Throws Error(kLimitExceeded).
[[noreturn]] void fail_too_small_tolerance();

/// A point of the grid: its coordinates are whole multiples of the step.
struct GridPoint {
  double x = 0;
  double y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// A box whose corners are points of the grid.
struct GridBox {
  GridPoint low, high;
};

/// The least box that holds some points.
struct Hull {
  double low_x = HUGE_VAL, low_y = HUGE_VAL;
  double high_x = -HUGE_VAL, high_y = -HUGE_VAL;

  void take(const Span& p) {
    low_x = std::min(low_x, p.x.low);
    low_y = std::min(low_y, p.y.low);
    high_x = std::max(high_x, p.x.high);
    high_y = std::max(high_y, p.y.high);
  }
};

/// The decimals that vertices of curves have.
class VertexGrid {
 public:
  /// Makes the grid whose step is the largest power of ten up to a 256th of the tolerance.
  explicit VertexGrid(const Rational& tolerance);
  [[nodiscard]] const Rational& step() const { return step_; }
  [[nodiscard]] double size() const { return size_; }
  /// Returns the multiple of the step that is nearest to a number. Throws Error(kLimitExceeded) if
  /// doubles do not tell it.
  [[nodiscard]] Rational near(const Rational& value) const { return at(steps_near(value)); }
  [[nodiscard]] double steps_near(const Rational& value) const;
  [[nodiscard]] Point at(const GridPoint& point) const { return {at(point.x), at(point.y)}; }
  /// Tells whether the diagonal of a box is no longer than this.
  [[nodiscard]] bool has_diagonal_within(const GridBox& box, double length) const;

 private:
  [[nodiscard]] Rational at(double steps) const;

  int exponent_ = 0;
  Rational step_;
  double size_;
};

/// The grid as seen from a point.
class GridView {
 public:
  GridView(const VertexGrid& grid, const Point& origin);

  /// Returns the grid's point that is nearest to one that is seen at (x, y). Throws
  /// Error(kLimitExceeded) if doubles do not tell it.
  [[nodiscard]] GridPoint near(double x, double y) const { return {near(x_, x), near(y_, y)}; }
  /// Returns a box around what is seen in `hull`, one step or two farther out.
  [[nodiscard]] GridBox around(const Hull& hull) const;
  /// Returns where a point of the grid is seen.
  [[nodiscard]] Span span_to(const GridPoint& point) const {
    return {offset(x_, point.x), offset(y_, point.y)};
  }

 private:
  /// A coordinate of the origin: in steps, it is a whole number and a rest.
  struct Axis {
    Rational origin;
    double whole;
    Interval rest;

    Axis(const VertexGrid& grid, const Rational& at);
  };
  [[nodiscard]] double near(const Axis& axis, double offset) const;
  [[nodiscard]] Interval offset(const Axis& axis, double steps) const {
    return (Interval(steps - axis.whole) - axis.rest) * step_;
  }

  const VertexGrid& grid_;
  Interval step_;
  Axis x_;
  Axis y_;
};

}  // namespace minksum::io

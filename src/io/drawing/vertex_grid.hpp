// Declares the grid on which vertices of curves lie, and rounds points to it.
#pragma once

#include "minksum/region.hpp"

namespace minksum::io {

/// Throws Error(kLimitExceeded).
[[noreturn]] void fail_too_small_tolerance();

/// The decimals that vertices of curves have.
class VertexGrid {
 public:
  /// Makes the grid whose step is the largest power of ten up to a 256th of the tolerance.
  explicit VertexGrid(const Rational& tolerance);
  [[nodiscard]] const Rational& step() const { return step_; }
  [[nodiscard]] double size() const { return size_; }
  /// Returns the multiple of the step that is nearest to a number. Throws Error(kLimitExceeded) if
  /// doubles do not tell it.
  [[nodiscard]] Rational near(const Rational& value) const;
  /// Returns the multiple by so many steps. Throws as above.
  [[nodiscard]] Rational at(double steps) const;

 private:
  int exponent_ = 0;
  Rational step_;
  double size_;
};

/// Rounds points to the grid that are given as seen from a point.
class GridView {
 public:
  GridView(const VertexGrid& grid, const Point& origin);

  /// Returns what VertexGrid::near returns for the exact sums of the point and (x, y). Throws as
  /// that does.
  [[nodiscard]] Point near(double x, double y) const { return {near(x_, x), near(y_, y)}; }

 private:
  /// A coordinate of the point: in steps, it is a whole number and a rest that is rounded.
  struct Axis {
    Rational origin;
    double whole;
    double rest;

    Axis(const VertexGrid& grid, const Rational& at);
  };
  [[nodiscard]] Rational near(const Axis& axis, double offset) const;

  const VertexGrid& grid_;
  Axis x_;
  Axis y_;
};

}  // namespace minksum::io

// Declares exact decisions about an overlay's points, segments and crossings.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "exact/big_integer.hpp"
#include "exact/formulas.hpp"
#include "exact/sign.hpp"
#include "minksum/region.hpp"

namespace minksum::overlay {

using PointId = std::uint32_t;

/// The segment between two points.
struct Ends {
  PointId low = 0;
  PointId high = 0;
};

/// A point of the overlay: a given point, or the crossing of two segments.
struct ExactLocation {
  Ends first;
  Ends second;
  bool is_crossing = false;

  static ExactLocation of_point(PointId point) { return {{point, point}, {}, false}; }
  static ExactLocation of_crossing(const Ends& a, const Ends& b) { return {a, b, true}; }
  [[nodiscard]] PointId point() const { return first.low; }
};

/// Holds the exact coordinates of all points and decides by them.
///
/// Points are homogeneous, (X : Y : W) with W > 0, and lines are their cross products, so no
/// formula divides. All formulas are implemented once (exact_points_of.hpp). Each rung has an
/// instance: 30, 61 and 125 bits of coordinate in integers of fixed width, and integers of any
/// size.
class ExactPoints {
 public:
  virtual ~ExactPoints() = default;

  /// Keeps only these points, and numbers them in this order.
  virtual void pick(std::span<const PointId> points) = 0;

  /// Returns the order by x, then by y.
  [[nodiscard]] virtual Sign compare(PointId a, PointId b) const = 0;
  [[nodiscard]] virtual Sign compare(const ExactLocation& a, const ExactLocation& b) const = 0;
  /// Returns kPositive if the point lies on the left of the line from low to high.
  [[nodiscard]] virtual Sign orientation(const Ends& line, PointId point) const = 0;
  [[nodiscard]] virtual Sign orientation(const Ends& line, const ExactLocation& place) const = 0;
  /// Returns kPositive if t's direction is counter-clockwise of s's, within half a turn.
  [[nodiscard]] virtual Sign cross(const Ends& s, const Ends& t) const = 0;
  /// Returns the sign of a ring's signed area.
  [[nodiscard]] virtual Sign area_sign(std::span<const PointId> ring) const = 0;

  /// The coefficients of a segment's line in lowest terms, equal for segments on one line. Slow.
  using Line = std::array<BigInteger, 3>;
  [[nodiscard]] virtual Line line(const Ends& ends) const = 0;

  /// Returns the nearest doubles, in a unit and from an origin of the rung's own. Numbers that
  /// underflow are off by less than kAbsoluteError.
  [[nodiscard]] virtual Vec<double> approximate(const ExactLocation& place) const = 0;
  static constexpr double kAbsoluteError = 0x1p-1020;
  /// Tells whether given points are integers in that unit.
  [[nodiscard]] virtual bool on_grid() const = 0;

  /// Returns the location in the coordinates that were given.
  [[nodiscard]] virtual Point exact(const ExactLocation& place) const = 0;
};

}  // namespace minksum::overlay

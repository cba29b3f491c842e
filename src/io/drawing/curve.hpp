// Declares the curves of drawings: chains of rational Bezier curves with exact ends.
#pragma once

#include <span>
#include <vector>

#include "io/drawing/bezier.hpp"
#include "io/drawing/interval.hpp"
#include "minksum/region.hpp"

namespace minksum::io {

/// A curve between two exact points. Its true control points lie within the intervals.
struct Curve {
  Point from;
  Point to;
  /// One behind the other. Coordinates are relative to `from`, where the first one begins.
  std::vector<Bezier<Interval>> parts;
  /// The last part, backwards and relative to `to`, where it begins.
  Bezier<Interval> ending;
};

/// A vector whose coordinates are not known exactly.
using Span = Vector<Interval>;
inline Span operator+(const Span& a, const Span& b) { return {a.x + b.x, a.y + b.y}; }
inline Span operator-(const Span& a, const Span& b) { return {a.x - b.x, a.y - b.y}; }
inline Span operator*(const Interval& f, const Span& a) { return {f * a.x, f * a.y}; }

/// Tells whether control points are all the same point.
[[nodiscard]] bool are_one_point(std::span<const Point> controls);

/// Returns the polynomial Bezier curve of two to twelve control points.
[[nodiscard]] Curve bezier_curve(std::span<const Point> controls);

/// Returns an arc of an ellipse. `half` is half of the way from its first end to the last one, and
/// `turned` is `half` after a quarter turn along the ellipse: (x, y) becomes (-y, x) on a circle.
/// `bulge` is the tangent of a quarter of the angle between the ends; it is negative for arcs that
/// go the other way. The ends are moved to `from` and `to`, so the arc moves no farther than they.
[[nodiscard]] Curve elliptical_arc(const Point& from, const Point& to, const Span& half,
                                   const Span& turned, const Interval& bulge);
/// Returns the arc of a circle between two exact points, by a bulge as above.
[[nodiscard]] Curve circular_arc(const Point& from, const Point& to, const Interval& bulge);

/// Returns a B-spline of a degree up to 11. There are controls.size() + degree + 1 knots, which do
/// not decrease, and a positive weight for each control point. Parameters are those from
/// knots[degree] to knots[controls.size()]. There must be a part that is more than a point.
/// The ends are moved to `from` and `to`.
[[nodiscard]] Curve spline_curve(const Point& from, const Point& to, std::size_t degree,
                                 std::span<const Point> controls, std::span<const Rational> knots,
                                 std::span<const Rational> weights);

/// Returns the parts of such a spline, relative to a point, without those that are points.
[[nodiscard]] std::vector<Bezier<Interval>> spline_parts(const Point& origin, std::size_t degree,
                                                         std::span<const Point> controls,
                                                         std::span<const Rational> knots,
                                                         std::span<const Rational> weights);

/// Returns point b as seen from point a.
[[nodiscard]] Span span_between(const Point& a, const Point& b);

}  // namespace minksum::io

// Declares what an offset has beside edges and at corners, as vectors from the vertices.
#pragma once

#include <initializer_list>
#include <vector>

#include "minksum/offset.hpp"
#include "operations/offset/decimal_grid.hpp"
#include "region/point_arithmetic.hpp"

namespace minksum {

/// A directed edge. Its outer side is its right side.
struct OffsetEdge {
  Point along;       ///< its direction; the length has no meaning
  Rational squared;  ///< the square of that length
  Point outwards;    ///< the normal to its right, as long as the distance; see Corners
};

/// The outline of the offset at a vertex, from the first edge's side to the second's.
///
/// The triangle of the vertex and two successive vectors is counter-clockwise, or it has no area:
/// each vector is to the left of the one before it or in line with it, or one of the two is (0, 0).
struct CornerOutline {
  std::vector<Point> full;  ///< from the first edge's `outwards` to the second's
  /// `full` without its first and last vector, if what is left starts and ends on the lines of the
  /// two moved edges. Then these edges can lead straight to it. Else the same as `full`.
  std::vector<Point> direct;
};

/// Makes corners for one distance d.
///
/// Let h be the grid's step and l the miter limit. h·l is at most a 64th of the tolerance. Vectors
/// are chosen in doubles and then verified exactly: `outwards` is within 2h of the normal of length
/// d, and a corner's vectors are within 2h of what follows from an edge's `outwards`. That is
/// within 3h·l of what follows from the normal. So all vectors are within 5h·l of the true ones,
/// which is less than a 12th of the tolerance.
class Corners {
 public:
  /// Takes the shape's join, miter limit and cap. Throws Error(kLimitExceeded) if the tolerance is
  /// too small to choose in doubles.
  Corners(const Rational& distance, const Rational& tolerance, const OffsetOptions& shape);

  /// Returns the edge in the direction of `along`, which is not (0, 0).
  [[nodiscard]] OffsetEdge edge(Point along) const;

  [[nodiscard]] CornerOutline at_vertex(const OffsetEdge& first, const OffsetEdge& second) const {
    return between(first, second, join_);
  }
  /// Returns the outline at the end of a polyline, where `second` goes straight back.
  [[nodiscard]] CornerOutline at_end(const OffsetEdge& first, const OffsetEdge& second) const;

 private:
  [[nodiscard]] CornerOutline between(const OffsetEdge& first, const OffsetEdge& second,
                                      Join join) const;
  [[nodiscard]] std::vector<Point> miter(const OffsetEdge& first, const OffsetEdge& second) const;
  [[nodiscard]] std::vector<Point> square(const OffsetEdge& first, const OffsetEdge& second) const;
  [[nodiscard]] std::vector<Point> arc(const Point& from, const Point& to) const;
  [[nodiscard]] Point beyond(const Point& outwards, double tangent,
                             std::initializer_list<const Point*> on) const;

  Rational distance_;
  Join join_;
  Cap cap_;
  Rational least_cosine_;  ///< cosine of the largest angle by which a mitred corner turns
  DecimalGrid grid_;
  Rational epsilon_;       ///< h/d
  Rational squared_step_;  ///< h²
  double distance_in_steps_;
  std::vector<Point> disc_;  ///< vertices by angle from −180 degrees; empty if nothing is round
};

}  // namespace minksum

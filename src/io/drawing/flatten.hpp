// Declares how curves become polylines within a tolerance, with a proof for each.
#pragma once

#include <vector>

#include "io/drawing/curve.hpp"
#include "io/drawing/vertex_grid.hpp"
#include "machine/cancellation.hpp"
#include "minksum/round.hpp"

namespace minksum::io {

/// Flattens curves.
///
/// A curve is cut into pieces. Each cut is a short segment across the curve, from a left end to a
/// right end, and both are on the grid. At the curve's own ends both are that end. Between two cuts
/// lies a quadrilateral that holds the piece: this is verified for the control points of a piece's
/// quarters, in intervals. Where a curve turns sharply, a box takes the place of a quadrilateral.
/// The polyline goes from the middle of each cut to that of the next one. So the curve can be moved
/// to the polyline within the quadrilaterals, and winding numbers differ only inside of them.
///
/// Every point of a quadrilateral is within the tolerance of the curve, unless the side is
/// kNearest. Then every point of the polyline is, and every point of the curve is as close to it.
class Flattener {
 public:
  Flattener(const Rational& tolerance, RoundingSide side);

  [[nodiscard]] const VertexGrid& grid() const { return grid_; }
  /// Adds the vertices of the polyline behind `curve.from` to `path`. If the side is not kNearest,
  /// adds rings to `ribbons`, all counter-clockwise, whose union is all quadrilaterals and boxes.
  /// Throws Error(kLimitExceeded) for a tolerance that is too small beside the coordinates.
  void flatten(const Curve& curve, std::vector<Point>& path, Region& ribbons,
               Cancellation& cancellation) const;

 private:
  double tolerance_;  ///< not more than the exact one
  RoundingSide side_;
  VertexGrid grid_;
};

}  // namespace minksum::io

// Finds the target's cells around points, and their convex hulls.
#pragma once

#include "minksum/region.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

/// A cell of the target around a point, between two neighbouring places in x and two in y. A side
/// has no length if the point's coordinate is in the target.
struct Cell {
  Point low;
  Point high;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// Returns the smallest cell that contains the point. If doubles are the target, throws
/// Error(kLimitExceeded) where that needs a coordinate beyond them.
[[nodiscard]] Cell cell_around(const Point& p, const Target& target);
/// Returns the cell with sides that have a length: a side without one is extended to the next
/// place.
[[nodiscard]] Cell thickened(Cell cell, const Target& target);

/// Tells whether both coordinates are in the target.
[[nodiscard]] bool is_on_target(const Point& p, const Target& target);

/// Returns the largest distance of a corner of the cell from a point in it, rounded up.
[[nodiscard]] double farthest_corner(const Cell& cell, const Point& p);

/// Returns the convex hull of both cells, counter-clockwise and without straight corners. If it has
/// no area, these are its two ends, or its only point.
[[nodiscard]] Ring hull_of(const Cell& a, const Cell& b);

}  // namespace minksum

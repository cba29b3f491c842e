// Cells of the target around points, and what they enclose.
#pragma once

#include "minksum/region.hpp"
#include "rounding/round_vertices.hpp"

namespace minksum {

/// Between two places in x and two in y, neighbours in the target. One side or both are of no
/// length if the point that it is around is of the target there.
struct Cell {
  Point low;
  Point high;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The smallest cell that contains the point. Throws Error(kBadInput) if that needs a coordinate
/// beyond the doubles, and those are the target.
[[nodiscard]] Cell cell_around(const Point& p, const Target& target);
/// A cell with sides of a length: where there is none, up to the next place.
[[nodiscard]] Cell thickened(Cell cell, const Target& target);

/// Whether both coordinates are of the target.
[[nodiscard]] bool is_on_target(const Point& p, const Target& target);

/// How far a corner of the cell is from a point in it, at most; rounded up.
[[nodiscard]] double farthest_corner(const Cell& cell, const Point& p);

/// The convex hull of both cells, counter-clockwise and without straight corners; if it has no
/// area, its two ends, or the only point.
[[nodiscard]] Ring hull_of(const Cell& a, const Cell& b);

}  // namespace minksum

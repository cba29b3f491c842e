// Makes random geometries that are as degenerate as possible.
#pragma once

#include <functional>

#include "minksum/geometry.hpp"
#include "support/geometries.hpp"
#include "support/random.hpp"

namespace minksum::test {

/// Returns up to three polygons of up to four rings, a polyline and some points. All are random on
/// a grid of 1 to 6 units, where nearly everything coincides. Rings cross and overlap themselves
/// and each other, run back over themselves, and collapse.
[[nodiscard]] Geometry random_mess(Random& random);

/// Returns a map that scales and moves along the axes without changing any order, to large
/// integers, decimals, or doubles far apart.
[[nodiscard]] std::function<Point(const Point&)> random_scaling(Random& random);
/// Returns a projective map for points that are not negative. Lines stay lines, and every point
/// gets a denominator of its own.
[[nodiscard]] std::function<Point(const Point&)> random_projection(Random& random);

/// Returns the geometry with every point replaced.
[[nodiscard]] Geometry transformed(const Geometry& geometry,
                                   const std::function<Point(const Point&)>& f);

}  // namespace minksum::test

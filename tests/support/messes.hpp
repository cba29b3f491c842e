// Random geometries that are as degenerate as it gets.
#pragma once

#include <functional>

#include "minksum/geometry.hpp"
#include "support/geometries.hpp"
#include "support/random.hpp"

namespace minksum::test {

/// Up to three polygons of up to four rings, a polyline and some points, all at random on a grid of
/// 1 to 6 units, where nearly everything coincides: rings cross and overlap themselves and each
/// other, go back the way that they came, and collapse.
[[nodiscard]] Geometry random_mess(Random& random);

/// A map that scales and moves along the axes, which changes no order: to large integers, decimals,
/// or doubles far apart.
[[nodiscard]] std::function<Point(const Point&)> random_scaling(Random& random);
/// A projective map for points that are not negative: lines stay lines, and every point gets a
/// denominator of its own.
[[nodiscard]] std::function<Point(const Point&)> random_projection(Random& random);

/// Every point replaced.
[[nodiscard]] Geometry transformed(const Geometry& geometry,
                                   const std::function<Point(const Point&)>& f);

}  // namespace minksum::test

// Makes random geometries with thin parts, and prints geometries.
#pragma once

#include <string>
#include <vector>

#include "minksum/geometry.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace minksum::test {

[[nodiscard]] Polyline make_polyline(const Outline& vertices);
[[nodiscard]] Geometry make_lines(const std::vector<Outline>& polylines,
                                  const Outline& points = {});

/// Returns a simple polyline of up to `edges` edges on a grid, without straight vertices. Sometimes
/// it is closed.
[[nodiscard]] Polyline random_simple_polyline(Random& random, int edges, int size);
/// Returns up to three polylines on a grid, and sometimes points. Polylines may cross themselves
/// and one another, and run back over themselves.
[[nodiscard]] Geometry random_thin(Random& random, int size);

[[nodiscard]] Geometry scaled(const Geometry& geometry, const Rational& factor);

/// Returns whether a ⊆ b as sets of points. Both geometries must be resolved.
[[nodiscard]] bool contains(const Geometry& b, const Geometry& a);

/// Returns exact WKT, part after part, for messages.
[[nodiscard]] std::string to_text(const Geometry& geometry);

}  // namespace minksum::test

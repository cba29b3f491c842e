// Geometries with thin parts: made at random, and printed.
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

/// A polyline of up to `edges` edges on a grid: simple, without straight vertices; now and then
/// closed.
[[nodiscard]] Polyline random_simple_polyline(Random& random, int edges, int size);
/// Up to three polylines on a grid, which may cross themselves and one another and run back over
/// themselves, and now and then points.
[[nodiscard]] Geometry random_thin(Random& random, int size);

[[nodiscard]] Geometry scaled(const Geometry& geometry, const Rational& factor);

/// Returns whether a ⊆ b, of resolved geometries: as sets, points and all.
[[nodiscard]] bool contains(const Geometry& b, const Geometry& a);

/// Exact WKT, part after part, for messages.
[[nodiscard]] std::string to_text(const Geometry& geometry);

}  // namespace minksum::test

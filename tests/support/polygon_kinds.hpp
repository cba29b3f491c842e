// Makes polygons of many kinds on integer grids, valid by construction or by an exact check.
#pragma once

#include "minksum/region.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace minksum::test {

/// Returns a vertex of the grid 0..size.
[[nodiscard]] Vertex random_vertex(Random& random, int size);
/// Returns a triangle on the grid 0..size.
[[nodiscard]] Region random_triangle(Random& random, int size);
/// Returns a polygon of up to `count` grid points, in angular order around an inner point.
[[nodiscard]] Region random_star_shaped(Random& random, int count, int size);
/// Returns a polygon of `count` grid points: a random tour whose crossings are undone one by one.
[[nodiscard]] Region random_two_opt(Random& random, int count, int size);
/// Returns the hull of some grid points.
[[nodiscard]] Region random_convex(Random& random, int count, int size);
/// Returns random cells of a small board, whole or halved along a diagonal. They often have
/// straight angles, holes, rings that touch at vertices and (unless `connected`) several parts.
[[nodiscard]] Region random_cells(Random& random, int columns, int rows, bool halves,
                                  bool connected);
/// Returns a random polygon with up to `holes` small holes, which may touch its outer ring or each
/// other at points.
[[nodiscard]] Region random_with_holes(Random& random, int size, int holes);

/// Returns a comb of `teeth` teeth. Each tooth and each gap is `width` wide and `height` high.
[[nodiscard]] Region comb(int teeth, std::int64_t width, std::int64_t height);
/// Returns a rectangular spiral of `turns` turns, whose corridor and wall are 1 wide.
[[nodiscard]] Region spiral(int turns);
/// Returns a star of `spikes` thin spikes, about `radius` high, on integers.
[[nodiscard]] Region spiky_star(Random& random, int spikes, int radius);
/// Returns a regular polygon of `corners` corners on a circle, rounded to integers.
[[nodiscard]] Region round_polygon(int corners, int radius);
/// Returns a box with these holes, which is larger by `margin` than the box of the holes.
[[nodiscard]] Region frame(const std::vector<Outline>& holes, std::int64_t margin);

}  // namespace minksum::test

// Kinds of polygons on integer grids, valid by construction or by an exact check.
#pragma once

#include "minksum/region.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace minksum::test {

/// A triangle on the grid 0..size.
[[nodiscard]] Region random_triangle(Random& random, int size);
/// Up to `count` grid points seen from an inner point in angular order.
[[nodiscard]] Region random_star_shaped(Random& random, int count, int size);
/// `count` grid points, a random tour, crossings undone one by one.
[[nodiscard]] Region random_two_opt(Random& random, int count, int size);
/// The hull of some grid points.
[[nodiscard]] Region random_convex(Random& random, int count, int size);
/// Random cells of a small board, whole or halved along a diagonal: straight angles, holes, rings
/// that touch at vertices and (unless `connected`) several parts come by themselves.
[[nodiscard]] Region random_cells(Random& random, int columns, int rows, bool halves,
                                  bool connected);
/// A random polygon with up to `holes` small holes, which may touch it or each other at points.
[[nodiscard]] Region random_with_holes(Random& random, int size, int holes);

/// A comb of `teeth` teeth, each and each gap `width` wide and `height` high.
[[nodiscard]] Region comb(int teeth, std::int64_t width, std::int64_t height);
/// A rectangular spiral of `turns` turns; corridor and wall 1 wide.
[[nodiscard]] Region spiral(int turns);
/// A star of `spikes` thin spikes, about `radius` high, on integers.
[[nodiscard]] Region spiky_star(Random& random, int spikes, int radius);
/// A regular polygon of `corners` corners on a circle, rounded to integers.
[[nodiscard]] Region round_polygon(int corners, int radius);
/// A box around hole(s): the outer box is `margin` wider than the box of the outline.
[[nodiscard]] Region frame(const std::vector<Outline>& holes, std::int64_t margin);

}  // namespace minksum::test

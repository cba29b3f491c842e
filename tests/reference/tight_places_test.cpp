// Tests the reference on tight places that can be found by hand.
#include "reference/tight_places.hpp"

#include <gtest/gtest.h>

#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace {

using minksum::Geometry;
using minksum::Point;
using minksum::Polyline;
using minksum::Region;
using minksum::reference::brute_force_tight_places;
using namespace minksum::test;

Geometry geometry(std::vector<Polyline> polylines, std::vector<Point> points) {
  return {{}, std::move(polylines), std::move(points)};
}

const Region square = rectangle(-1, -1, 1, 1);

TEST(BruteForceTight, NothingAmongConvexOperands) {
  EXPECT_EQ(brute_force_tight_places(square, square), Geometry{});
  EXPECT_EQ(brute_force_tight_places(square, Region{}), Geometry{});
}

TEST(BruteForceTight, PointsAndLines) {
  EXPECT_EQ(brute_force_tight_places(frame({{{2, 2}, {2, 4}, {4, 4}, {4, 2}}}, 2), square),
            geometry({}, {{3, 3}}));
  EXPECT_EQ(brute_force_tight_places(frame({{{2, 2}, {2, 7}, {4, 7}, {4, 2}}}, 2), square),
            geometry({{{3, 3}, {3, 6}}}, {}));
  EXPECT_EQ(brute_force_tight_places(frame({{{2, 2}, {2, 5}, {5, 5}, {5, 2}}}, 2), square),
            Geometry{});
  const Region slot =
      make_polygon({{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 2}, {2, 2}, {2, 6}, {0, 6}});
  EXPECT_EQ(brute_force_tight_places(slot, rectangle(-1, 0, 1, 3)),
            geometry({{{3, 5}, {3, 9}}}, {}));
}

TEST(BruteForceTight, BranchesAndTurns) {
  const Region plus = frame(
      {{{2, 5}, {2, 7}, {5, 7}, {5, 10}, {7, 10}, {7, 7}, {10, 7}, {10, 5}, {7, 5}, {7, 2}, {5, 2},
        {5, 5}}},
      2);
  EXPECT_EQ(brute_force_tight_places(plus, square),
            geometry({{{3, 6}, {6, 6}}, {{6, 3}, {6, 6}}, {{6, 6}, {6, 9}}, {{6, 6}, {9, 6}}}, {}));
  const Region angle = frame({{{2, 2}, {2, 8}, {4, 8}, {4, 4}, {8, 4}, {8, 2}}}, 2);
  EXPECT_EQ(brute_force_tight_places(angle, square), geometry({{{3, 7}, {3, 3}, {7, 3}}}, {}));
}

TEST(BruteForceTight, RoundAnIsland) {
  const Region island =
      make_region({{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{1, 1}, {1, 7}, {7, 7}, {7, 1}}},
                   {{{3, 3}, {5, 3}, {5, 5}, {3, 5}}}});
  EXPECT_EQ(brute_force_tight_places(island, square),
            geometry({{{2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}}}, {}));
}

}  // namespace

// Tests the search for inner points of regions that a coarse grid misses.
#include <gtest/gtest.h>

#include "minksum/boolean.hpp"
#include "minksum/locate.hpp"
#include "minksum/transform.hpp"
#include "operations/configuration_space/free_part.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

void expect_inside(const Region& region) {
  const Point point = point_within(region, {0, 0}, {100, 100}, {});
  EXPECT_EQ(PointLocator({region, {}, {}}).locate(point), Location::kInside)
      << test::to_text(region);
}

TEST(PointWithin, ThinShapes) {
  expect_inside(test::rectangle(0, 0, 100, 1));
  expect_inside(test::make_polygon({{0, 0}, {1000, 999}, {999, 1000}}));
  expect_inside(test::make_polygon({{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                   {{{0, 50}, {50, 99}, {99, 50}, {50, 1}}}));
}

// The largest gap between heights holds no shape.
TEST(PointWithin, ThinShapesFarApart) {
  const Region low = test::rectangle(0, 0, 100, 1);
  expect_inside(unite(low, test::rectangle(0, 99, 100, 100)));
  expect_inside(unite(unite(low, test::rectangle(0, 99, 100, 100)), test::rectangle(0, 2, 1, 98)));
  const Region needle = test::make_polygon({{0, 0}, {1000, 999}, {999, 1000}});
  expect_inside(unite(needle, transform(needle, Affine::translation(5000, 7000))));
}

}  // namespace
}  // namespace minksum

// Tests that erosions and free space with tight places are resolved.
#include "minksum/morphology.hpp"

#include <gtest/gtest.h>

#include "minksum/configuration_space.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/resolve.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

Options with_tight_places() {
  Options options;
  options.tight = true;
  return options;
}

/// A room, and a triangle whose placements without play lead past (3, 2), a corner of its other
/// placements.
Geometry room() {
  return test::make_polygon(
      {{2, 2}, {5, 2}, {5, 6}, {2, 6}},
      {{{2, 3}, {3, 3}, {3, 4}}, {{4, 2}, {5, 3}, {4, 3}}, {{4, 4}, {5, 5}, {4, 5}}});
}
Geometry triangle() { return test::make_polygon({{1, 1}, {1, 2}, {0, 2}}); }

TEST(Morphology, TightPlacesEndAtCornersOfTheErosion) {
  const Geometry inner = erode(room(), triangle(), with_tight_places());
  ASSERT_EQ(inner.polylines.size(), 3U);
  EXPECT_EQ(inner, resolve(inner));
  const Geometry fits = inner_fit_polygon(room(), triangle(), Point{0, 0});
  EXPECT_EQ(fits, inner);
}

TEST(Morphology, TightPlacesEndAtCornersOfFreeSpace) {
  ConfigurationOptions setting;
  setting.workspace = room();
  const ConfigurationSpace space(triangle(), {}, setting, with_tight_places());
  const Slice slice = space.slice(nearest_turn(0), true);
  EXPECT_EQ(slice.free, erode(room(), triangle(), with_tight_places()));
}

}  // namespace
}  // namespace minksum

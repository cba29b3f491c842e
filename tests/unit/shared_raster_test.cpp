// One raster of the first operand for many sums: the same sums.
#include "cover/shared_raster.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fixed_sum.hpp"
#include "minksum/configuration_space.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

Region turned_by(const Region& region, int degrees) {
  return transform(region, nearest_turn(Rational(degrees)).map());
}

/// A room with a slot that a bar fits into upright, but not lying.
Region room_with_slot() {
  return test::make_polygon({{0, 0}, {400, 0}, {400, 300}, {0, 300}},
                            {{{30, 20}, {30, 280}, {75, 280}, {75, 20}}});
}

/// What a shared raster covers in the sums of `fixed` with `moving`, turned.
std::uint64_t expect_same_sums(const Region& fixed, const Region& moving, int grid,
                               const std::string& what) {
  Options sharing;
  sharing.grid = grid;
  const PreparedRegion prepared(fixed);
  const auto shared = share_raster(prepared, moving, 400, sharing);
  if (!shared) return 0;
  Workspace workspace;
  Region sum;
  Statistics statistics;
  Options options;
  options.check = true;
  options.statistics = &statistics;
  std::uint64_t covered = 0;
  for (const int degrees : {0, 1, 17, 45, 90, 133, 201, 359}) {
    const Region turned = turned_by(moving, degrees);
    const Outcome outcome = minkowski_sum(prepared, turned, &*shared, options, workspace, sum);
    EXPECT_TRUE(outcome.ok()) << what << ", turned by " << degrees;
    EXPECT_EQ(sum, minkowski_sum(fixed, turned)) << what << ", turned by " << degrees;
    covered += statistics.covered_cells;
  }
  return covered;
}

Geometry as_geometry(const Region& region) { return {region, {}, {}}; }

TEST(SharedRaster, GivesTheSameSums) {
  Random random(1);
  const struct {
    const char* name;
    Region fixed;
    Region moving;
  } pairs[] = {
      {"random polygons", test::random_two_opt(random, 60, 300),
       test::random_two_opt(random, 20, 90)},
      {"holes", test::random_with_holes(random, 150, 4), test::random_two_opt(random, 12, 30)},
      {"holes in both", test::random_with_holes(random, 90, 3),
       test::random_with_holes(random, 60, 2)},
      {"a comb", test::comb(14, 3, 120), test::random_two_opt(random, 20, 50)},
      {"a bar and a slot", room_with_slot(), test::rectangle(-20, -100, 20, 100)},
      {"the bar turns first", room_with_slot(), test::rectangle(-100, -20, 100, 20)},
  };
  for (const auto& [name, fixed, moving] : pairs) {
    std::uint64_t covered = 0;
    for (const int grid : {8, 40, 150}) {
      covered += expect_same_sums(fixed, moving, grid, name + (" on grid " + std::to_string(grid)));
    }
    EXPECT_GT(covered, 1000U) << name;
  }
}

// A hole that the typical operand does not fit into must not be covered for one that does.
TEST(SharedRaster, KeepsNarrowHoles) {
  const Region room = room_with_slot();
  const Region bar = test::rectangle(-100, -20, 100, 20);
  const Region upright = turned_by(bar, 90);
  EXPECT_EQ(minkowski_sum(room, bar).ring_count(), 1U);
  EXPECT_EQ(minkowski_sum(room, upright).ring_count(), 2U);
  Options options;
  options.grid = 64;
  const PreparedRegion prepared(room);
  const auto shared = share_raster(prepared, bar, 250, options);
  ASSERT_TRUE(shared);
  Workspace workspace;
  Region sum;
  ASSERT_TRUE(minkowski_sum(prepared, upright, &*shared, {}, workspace, sum).ok());
  EXPECT_EQ(sum, minkowski_sum(room, upright));
}

// Second operands that are wider than was said.
TEST(SharedRaster, FallsBackWhereRowsAreTooShort) {
  Random random(2);
  const Region fixed = test::random_two_opt(random, 60, 300);
  const Region moving = test::random_two_opt(random, 20, 90);
  Options options;
  options.grid = 100;
  const PreparedRegion prepared(fixed);
  const auto shared = share_raster(prepared, moving, 90, options);
  ASSERT_TRUE(shared);
  const Region large = test::scaled(moving, Rational(20));
  Workspace workspace;
  Region sum;
  ASSERT_TRUE(minkowski_sum(prepared, large, &*shared, {}, workspace, sum).ok());
  EXPECT_EQ(sum, minkowski_sum(fixed, large));
}

TEST(SharedRaster, IsNotMadeWhereThereIsNoCover) {
  const PreparedRegion square(test::rectangle(0, 0, 9, 9));
  EXPECT_FALSE(share_raster(square, test::rectangle(0, 0, 3, 3), 9, {}));
  Random random(3);
  const PreparedRegion small(test::random_two_opt(random, 9, 50));
  EXPECT_FALSE(share_raster(small, test::random_two_opt(random, 9, 50), 100, {}));
}

// Many slices share one; a single one has its own.
TEST(SharedRaster, OfSlices) {
  Random random(4);
  const Region robot = test::random_two_opt(random, 30, 60);
  const Region obstacles = test::random_with_holes(random, 400, 9);
  ConfigurationOptions options;
  options.tight = true;
  const ConfigurationSpace space(as_geometry(robot), as_geometry(obstacles), options);
  const std::vector<Turn> turns = full_turn(12);
  const std::vector<Slice> slices = space.slices(turns, true);
  ASSERT_EQ(slices.size(), turns.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Slice single = space.slice(turns[i], true);
    EXPECT_EQ(slices[i].obstacles, single.obstacles) << i;
    EXPECT_EQ(slices[i].free, single.free) << i;
  }
}

}  // namespace
}  // namespace minksum

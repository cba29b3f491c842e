// Tests that sums that share one raster of the first operand are the same.
#include "sum/cover/shared_raster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "minksum/configuration_space.hpp"
#include "minksum/testing.hpp"
#include "operations/sum/fixed_sum.hpp"
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

/// Returns a room with a slot into which a bar fits upright, but not lying.
Region room_with_slot() {
  return test::make_polygon({{0, 0}, {400, 0}, {400, 300}, {0, 300}},
                            {{{30, 20}, {30, 280}, {75, 280}, {75, 20}}});
}

/// Compares sums of `fixed` with `moving`, turned. Returns how many cells a shared raster covers.
std::uint64_t expect_same_sums(const Region& fixed, const Region& moving, int grid,
                               const std::string& what) {
  SumRequest sharing;
  sharing.grid = grid;
  const PreparedRegion prepared(fixed);
  const auto shared = share_raster(prepared, moving, 400, sharing);
  if (!shared) return 0;
  Workspace workspace;
  Region sum;
  Statistics statistics;
  SumRequest options;
  options.check = true;
  options.statistics = &statistics;
  std::uint64_t covered = 0;
  for (const int degrees : {0, 1, 17, 45, 90, 133, 201, 359}) {
    const Region turned = turned_by(moving, degrees);
    minkowski_sum(prepared, turned, &*shared, options, workspace, sum);
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

// If the typical operand does not fit into a hole, another one may, so the hole stays uncovered.
TEST(SharedRaster, KeepsNarrowHoles) {
  const Region room = room_with_slot();
  const Region bar = test::rectangle(-100, -20, 100, 20);
  const Region upright = turned_by(bar, 90);
  EXPECT_EQ(minkowski_sum(room, bar).ring_count(), 1U);
  EXPECT_EQ(minkowski_sum(room, upright).ring_count(), 2U);
  SumRequest options;
  options.grid = 64;
  const PreparedRegion prepared(room);
  const auto shared = share_raster(prepared, bar, 250, options);
  ASSERT_TRUE(shared);
  Workspace workspace;
  Region sum;
  minkowski_sum(prepared, upright, &*shared, SumRequest{}, workspace, sum);
  EXPECT_EQ(sum, minkowski_sum(room, upright));
}

// The second operands are wider than announced.
TEST(SharedRaster, FallsBackWhereRowsAreTooShort) {
  Random random(2);
  const Region fixed = test::random_two_opt(random, 60, 300);
  const Region moving = test::random_two_opt(random, 20, 90);
  SumRequest options;
  options.grid = 100;
  const PreparedRegion prepared(fixed);
  const auto shared = share_raster(prepared, moving, 90, options);
  ASSERT_TRUE(shared);
  const Region large = test::scaled(moving, Rational(20));
  Workspace workspace;
  Region sum;
  minkowski_sum(prepared, large, &*shared, SumRequest{}, workspace, sum);
  EXPECT_EQ(sum, minkowski_sum(fixed, large));
}

TEST(SharedRaster, IsNotMadeWhereThereIsNoCover) {
  const PreparedRegion square(test::rectangle(0, 0, 9, 9));
  EXPECT_FALSE(share_raster(square, test::rectangle(0, 0, 3, 3), 9, {}));
  Random random(3);
  const PreparedRegion large(test::random_two_opt(random, 40, 100000));
  EXPECT_FALSE(share_raster(large, test::rectangle(0, 0, 1, 1), 1, {}));
}

/// Expects that slices made together equal those made one by one with the same limits, or that both
/// fail.
void expect_same_slices(const Region& robot, const Region& obstacles, const Limits& limits,
                        const std::vector<Turn>& turns, const std::string& what) {
  const ConfigurationSpace space(as_geometry(robot), as_geometry(obstacles), {},
                                 {.limits = limits});
  const auto one_by_one = [&] {
    std::vector<Slice> slices;
    for (const Turn& turn : turns) slices.push_back(space.slice(turn));
    return slices;
  };
  const auto without_throwing = [](auto make) -> std::optional<std::vector<Slice>> {
    try {
      return make();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
      return std::nullopt;
    }
  };
  const auto expected = without_throwing(one_by_one);
  const auto slices = without_throwing([&] { return space.slices(turns); });
  ASSERT_EQ(slices.has_value(), expected.has_value()) << what;
  for (std::size_t i = 0; slices && i < slices->size(); ++i) {
    EXPECT_EQ((*slices)[i].obstacles, (*expected)[i].obstacles) << what;
  }
}

/// Returns a comb with thin teeth of many heights on a thick back.
Region tall_comb(Random& random, int teeth, int gap, int height, int back) {
  test::Outline ring{{0, -back}, {2 * gap * teeth, -back}};
  for (int i = teeth - 1; i >= 0; --i) {
    const auto x = 2 * gap * i + static_cast<std::int64_t>(random.below(gap));
    const auto top = height + static_cast<std::int64_t>(random.below(height / 4));
    const auto end = x + 2 + static_cast<std::int64_t>(random.below(2));
    for (const auto& at : {test::Vertex{end, 0}, {end, top}, {x, top}, {x, 0}}) ring.push_back(at);
  }
  return test::make_polygon(ring);
}

// A grid that suits the first turn may leave all crossings of another one.
TEST(SharedRaster, OtherTurnsMayBeHarder) {
  Random random(40);
  const Region obstacles = tall_comb(random, 40, 30, 2400, 1500);
  const Region robot = tall_comb(random, 20, 25, 800, 200);
  for (const std::uint64_t most : {3000U, 10000U, 30000U}) {
    Limits limits;
    limits.max_crossings = most;
    expect_same_slices(robot, obstacles, limits, full_turn(8),
                       std::to_string(most) + " crossings at most");
  }
}

// Segments of narrow holes do not count for any slice.
TEST(SharedRaster, NarrowHolesCountForNoLimit) {
  Random random(5);
  std::vector<test::Outline> holes;
  for (int i = 0; i < 100; ++i) {
    const int x = -450 + 90 * (i % 10);
    const int y = -450 + 90 * (i / 10);
    holes.push_back({{x, y}, {x, y + 10}, {x + 10, y + 10}, {x + 10, y}});
  }
  test::Outline circle;
  const Region round = test::round_polygon(200, 1000);
  for (const std::size_t v : round.vertices_of(0)) {
    circle.push_back(
        {static_cast<std::int64_t>(round.x(v)), static_cast<std::int64_t>(round.y(v))});
  }
  const Region obstacles = test::make_polygon(circle, holes);
  const Region robot = test::random_two_opt(random, 40, 300);
  for (const std::uint64_t most : {300U, 1000U, 1500U, 2000U, 4000U, 100000U}) {
    Limits limits;
    limits.max_segments = most;
    expect_same_slices(robot, obstacles, limits, full_turn(8),
                       std::to_string(most) + " segments at most");
  }
}

// The side of a cell would have few bits, or be zero.
TEST(SharedRaster, TinyCoordinates) {
  std::vector<Turn> turns;
  for (int i = 0; i < 8; ++i) turns.push_back(nearest_turn(Rational(90 * i)));
  for (const int exponent : {-1074, -1073, -1071, -1000, -890, 890, 1000}) {
    for (int seed = 0; seed < 8; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const Rational unit = Rational(std::ldexp(1.0, exponent));
      const Region obstacles = test::scaled(test::random_two_opt(random, 120, 180), unit);
      const Region robot = test::scaled(test::random_two_opt(random, 30, 36), unit);
      expect_same_slices(robot, obstacles, {}, turns, "times two to " + std::to_string(exponent));
    }
  }
}

// Many slices share one raster; a single slice has its own.
TEST(SharedRaster, OfSlices) {
  Random random(4);
  const Region robot = test::random_two_opt(random, 30, 60);
  const Region obstacles = test::random_with_holes(random, 400, 9);
  const ConfigurationSpace space(as_geometry(robot), as_geometry(obstacles), {}, {.tight = true});
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

// Tests slices of configuration spaces against collision tests of the placed robot and by law.
#include "minksum/configuration_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "minksum/boolean.hpp"
#include "minksum/locate.hpp"
#include "minksum/resolve.hpp"
#include "reference/placed_robot.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/robot_scenes.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::as_geometry;
using test::Random;

/// Returns a random angle from one of several grids.
Rational random_angle(Random& random) {
  switch (random.below(4)) {
    case 0:
      return Rational(90 * random.between(-5, 5));
    case 1:
      return Rational(45 * random.between(-9, 9));
    case 2:
      return Rational(random.between(-4000, 4000), 10);
    default:
      return {random.between(-99999, 99999), 277};
  }
}

/// Counts the tried places that are free, and those of them without play.
struct Found {
  int free = 0;
  int thin = 0;
};

/// Returns whether the robot collides in every direction from here.
bool has_no_play(const reference::PlacedRobot& robot, const reference::Pt& at,
                 const reference::Pt& direction) {
  using reference::Number;
  // The robot cannot have play along a path in any of these directions.
  const Number hair("1/1000000000000000000000");
  for (const int x : {-10007, -7919, -3571, -1301, 1709, 4211, 7103, 9973}) {
    for (const int y : {-9463, -6653, -4919, -1847, 1447, 3307, 8167, 10463}) {
      const reference::Pt near{Number(at.x + hair * x), Number(at.y + hair * y)};
      if (robot.at(near, direction) == reference::Collision::kNone) return false;
    }
  }
  return true;
}

void expect_collisions(Random& random, const test::RobotScene& scene,
                       const ConfigurationSpace& space, const Slice& slice, int places,
                       Found& found) {
  const PointLocator free(slice.free);
  const PointLocator area({slice.free.region, {}, {}});
  const PointLocator obstacles(slice.obstacles);
  const reference::PlacedRobot robot(scene.robot, scene.setting.reference, scene.obstacles,
                                     scene.workspace());
  const reference::Pt direction = reference::direction_of(slice.turn);
  for (int i = 0; i < places; ++i) {
    const Point at = test::random_place(random, scene, slice, space.boundary());
    const Box& box = space.boundary();
    if (at.x < box.min.x || at.y < box.min.y || at.x > box.max.x || at.y > box.max.y) {
      continue;  // free space ends at the box anyway
    }
    const bool is_free = robot.at(reference::to_pt(at), direction) == reference::Collision::kNone;
    const bool found_free = free.locate(at) != Location::kOutside;
    ASSERT_TRUE(found_free == is_free ||
                (is_free && !scene.tight && has_no_play(robot, reference::to_pt(at), direction)))
        << test::to_text(scene) << '\n'
        << slice.turn.asked << ' ' << at.x << ' ' << at.y;
    // Free space and obstacles share only their boundaries and the thin parts.
    const bool thin = found_free && area.locate(at) == Location::kOutside;
    if (!thin) {
      ASSERT_EQ(found_free, obstacles.locate(at) != Location::kInside) << test::to_text(scene);
    }
    found.free += found_free ? 1 : 0;
    found.thin += thin ? 1 : 0;
  }
}

// MINKSUM_PAIRS is the number of scenes, each with 50 configurations.
TEST(ConfigurationSpace, AgreesWithCollisionTests) {
  const std::uint64_t seed = test::seed_from_environment(1);
  SCOPED_TRACE(seed);
  Random random(seed);
  const int scenes = test::count_from_environment(400);
  constexpr int kPlaces = 50;
  Found found;
  for (int i = 0; i < scenes && !HasFatalFailure(); ++i) {
    SCOPED_TRACE(i);
    test::RobotScene scene = test::random_robot_scene(random);
    scene.tight = !scene.obstacles.has_thin_parts();
    const ConfigurationSpace space(as_geometry(scene.robot), scene.obstacles, scene.setting,
                                   {.tight = scene.tight});
    const Turn turn = random.one_in(3) ? nearest_turn(random_angle(random)) : scene.turn;
    expect_collisions(random, scene, space, space.slice(turn, true), kPlaces, found);
  }
  EXPECT_GT(found.free, scenes * kPlaces / 10);
  EXPECT_LT(found.free, scenes * kPlaces * 9 / 10);
  if (scenes >= 80) {
    EXPECT_GT(found.thin, 0);
  }
}

TEST(ConfigurationSpace, WithoutATurnItIsTheSum) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const test::Pair pair = test::random_pair(random);
    const ConfigurationSpace space(as_geometry(pair.q), as_geometry(pair.p));
    EXPECT_EQ(space.slice(nearest_turn(0)).obstacles.region,
              minkowski_sum(pair.p, reflect(pair.q)));
  }
}

// Turning everything by a quarter turns the slices by one.
TEST(ConfigurationSpace, QuarterTurns) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const test::Pair pair = test::random_pair(random);
    const ConfigurationSpace space(as_geometry(pair.q), as_geometry(pair.p));
    const ConfigurationSpace turned(as_geometry(pair.q), as_geometry(test::turned(pair.p)));
    const Rational angle = random_angle(random);
    const Slice slice = space.slice(nearest_turn(angle));
    const Slice other = turned.slice(nearest_turn(angle + Rational(90)));
    EXPECT_EQ(other.turn.tan_half, slice.turn.tan_half);
    EXPECT_EQ(resolve(transform(slice.obstacles, Affine::quarter_turns(1))), other.obstacles);
  }
}

// The reference point only moves slices, in every turn.
TEST(ConfigurationSpace, ReferencePoint) {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const test::Pair pair = test::random_pair(random);
    ConfigurationOptions options;
    options.reference = {Rational(random.between(-9, 9), 7), Rational(random.between(-9, 9))};
    const ConfigurationSpace space(as_geometry(pair.q), as_geometry(pair.p), options);
    const ConfigurationSpace home(
        as_geometry(test::moved(pair.q, -options.reference.x, -options.reference.y)),
        as_geometry(pair.p));
    const Turn turn = nearest_turn(random_angle(random));
    EXPECT_EQ(space.slice(turn).obstacles, home.slice(turn).obstacles);
    const Rational& reach = space.radius();
    for (std::size_t v = 0; v < pair.q.vertex_count(); ++v) {
      const Point p = pair.q.point(v);
      const Point d{p.x - options.reference.x, p.y - options.reference.y};
      EXPECT_LE(d.x * d.x + d.y * d.y, reach * reach);
    }
  }
}

TEST(ConfigurationSpace, WallsMayBeThin) {
  const Region robot = test::make_polygon({{0, 0}, {4, 1}, {1, 3}});
  const Geometry walls{test::rectangle(20, 20, 30, 30), {{{0, 0}, {10, 0}, {10, 30}}}, {{40, 5}}};
  const ConfigurationSpace space(as_geometry(robot), walls);
  for (const int angle : {0, 37, 90, 200}) {
    const Slice slice = space.slice(nearest_turn(angle), true);
    const Geometry mirrored =
        transform(as_geometry(robot), Affine::scaling(Rational(-1)).after(slice.turn.map()));
    EXPECT_EQ(slice.obstacles, minkowski_sum(walls, mirrored));
    EXPECT_FALSE(slice.obstacles.has_thin_parts());
    EXPECT_EQ(slice.obstacles.region.polygon_count(), 3U);
    EXPECT_TRUE(intersect(slice.free.region, slice.obstacles.region).empty());
  }
}

TEST(ConfigurationSpace, NothingInTheWay) {
  const ConfigurationSpace space(as_geometry(test::rectangle(0, 0, 3, 4)), {});
  const Slice slice = space.slice(nearest_turn(30), true);
  EXPECT_TRUE(slice.obstacles.empty());
  EXPECT_EQ(slice.free.region, resolve(as_geometry(test::rectangle(-10, -10, 10, 10))).region);
  EXPECT_EQ(space.radius(), Rational(5));
}

// Squares of the robot's coordinates are beyond all doubles.
TEST(ConfigurationSpace, RobotsOfAnySize) {
  const Region square = test::rectangle(0, 0, 1, 1);
  for (const int exponent : {-300, 300}) {
    const Rational size(Decimal{1, exponent});
    const Region robot = test::scaled(square, size);
    const ConfigurationSpace space(as_geometry(robot), as_geometry(square));
    EXPECT_GE(space.radius() * space.radius(), size * size * Rational(2));
    EXPECT_LE(space.radius(), size * Rational(3, 2));
    EXPECT_EQ(space.slice(nearest_turn(0)).obstacles.region, minkowski_sum(square, reflect(robot)));
  }
}

TEST(ConfigurationSpace, ThreadsGiveSlicesInOrder) {
  Random random(5);
  const Region robot = test::random_two_opt(random, 12, 20);
  const Region obstacles = test::random_with_holes(random, 90, 3);
  Options options;
  std::vector<Slice> expected;
  const std::vector<Turn> turns = full_turn(50);
  for (const int threads : {1, 2, 7, 100}) {
    options.threads = threads;
    const ConfigurationSpace space(as_geometry(robot), as_geometry(obstacles), {}, options);
    std::vector<Slice> slices = space.slices(turns, true);
    ASSERT_EQ(slices.size(), turns.size());
    if (threads == 1) expected = slices;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      EXPECT_EQ(slices[i].turn.asked, turns[i].asked);
      EXPECT_EQ(slices[i].obstacles, expected[i].obstacles);
      EXPECT_EQ(slices[i].free, expected[i].free);
    }
    EXPECT_TRUE(space.slices({}).empty());
  }
}

// Of the exceptions of all threads, the first in the order of slices arrives.
TEST(ConfigurationSpace, FailuresOfThreads) {
  Options options;
  const Geometry square = as_geometry(test::rectangle(0, 0, 9, 9));
  const std::vector<Turn> turns = full_turn(30);
  for (const int threads : {1, 3}) {
    options.threads = threads;
    const ConfigurationSpace space(square, square, {}, options);
    const auto throw_at = [](std::size_t from) {
      return [from](std::size_t i, Slice&) {
        if (i >= from) throw std::runtime_error(std::to_string(i));
      };
    };
    const auto nothing = [](std::size_t, Slice&) {};
    for (const std::size_t from : {0U, 7U, 29U}) {
      for (const bool in_finish : {true, false}) {
        try {
          space.for_each_slice(
              turns, false,
              in_finish ? std::function<void(std::size_t, Slice&)>(throw_at(from)) : nothing,
              in_finish ? std::function<void(std::size_t, Slice&)>(nothing) : throw_at(from));
          FAIL();
        } catch (const std::runtime_error& error) {
          EXPECT_EQ(error.what(), std::to_string(from));
        }
      }
    }
  }
}

TEST(ConfigurationSpace, CanBeCancelled) {
  Options options;
  options.threads = 2;
  options.cancel.emplace();
  const Geometry square = as_geometry(test::rectangle(0, 0, 9, 9));
  const ConfigurationSpace space(square, square, {}, options);
  std::size_t seen = 0;
  try {
    space.for_each_slice(full_turn(1000), true, {}, [&](std::size_t, Slice&) {
      if (++seen == 3) options.cancel->cancel();
    });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
  EXPECT_LT(seen, 50U);
}

TEST(ConfigurationSpace, BadInput) {
  const Geometry square = as_geometry(test::rectangle(0, 0, 9, 9));
  const Geometry line{{}, {{{0, 0}, {1, 1}}}, {}};
  const Geometry bow = as_geometry(test::make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 3}}));
  const auto expect_refused = [](const Geometry& robot, const Geometry& obstacles,
                                 const ConfigurationOptions& setting, int operand,
                                 const Options& options = {}) {
    try {
      const ConfigurationSpace space(robot, obstacles, setting, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
      EXPECT_EQ(error.culprit().operand, operand);
    }
  };
  ConfigurationOptions setting;
  expect_refused(line, square, setting, 0);
  expect_refused({}, square, setting, 0);
  setting.workspace = line;
  expect_refused(square, square, setting, 2);
  setting.workspace.reset();
  // Places without play among lines are not known.
  expect_refused(square, line, setting, 1, {.tight = true});
  expect_refused(square, {{}, {}, {{0, 0}}}, setting, 1, {.tight = true});
  const Options strict{.fill = FillRule::kStrict};
  expect_refused(bow, square, setting, 0, strict);
  expect_refused(square, bow, setting, 1, strict);
  setting.workspace = bow;
  expect_refused(square, square, setting, 2, strict);
}

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

TEST(Turn, IsTheSimplestWithinItsTolerance) {
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Rational angle = random_angle(random);
    const double tolerance = std::pow(10.0, -random.between(0, 4));
    const Turn turn = nearest_turn(angle, tolerance);
    EXPECT_EQ(turn.asked, angle);
    EXPECT_LE(turn.off, tolerance);
    EXPECT_LE(std::abs(turn.degrees - angle.to_double()), turn.off + 1e-10);
    const double rest = angle.to_double() - 90 * std::floor(angle.to_double() / 90);
    // No fraction with a smaller denominator is clearly within the tolerance.
    const auto q = static_cast<std::int64_t>(turn.tan_half.denominator().to_double());
    const double inner = tolerance * 0.999999;
    for (std::int64_t smaller = 1; smaller < q; ++smaller) {
      const auto size = static_cast<double>(smaller);
      const double low = std::max(0.0, tangent((rest - inner) / 2)) * size;
      EXPECT_GT(std::ceil(low), tangent((rest + inner) / 2) * size) << angle << ' ' << smaller;
    }
    // The turn turns by the angle that it reports.
    const Point to = turn.direction();
    EXPECT_EQ(to.x * to.x + to.y * to.y, Rational(1));
    EXPECT_NEAR(to.x.to_double(), std::cos(turn.degrees * std::numbers::pi / 180), 1e-9);
    EXPECT_NEAR(to.y.to_double(), std::sin(turn.degrees * std::numbers::pi / 180), 1e-9);
  }
}

TEST(Turn, QuartersAreExact) {
  for (int i = -9; i <= 9; ++i) {
    const Turn turn = nearest_turn(90 * i);
    EXPECT_EQ(turn.off, 0);
    EXPECT_EQ(turn.degrees, 90 * i);
    EXPECT_EQ(turn.tan_half, Rational(0));
    EXPECT_EQ(turn.quarters, ((i % 4) + 4) % 4);
  }
  EXPECT_EQ(full_turn(4)[3].quarters, 3);
  EXPECT_EQ(full_turn(7)[1].asked, Rational(360, 7));
}

TEST(Turn, AtTheEndsOfAQuarter) {
  for (const double tolerance : {1e-10, 1e-6, 1e-3, 1.0}) {
    for (const double off : {1e-14, 1e-9, 1e-4, 0.5}) {
      for (const int quarter : {-400, -90, 0, 90, 360}) {
        for (const int side : {-1, 1}) {
          const Rational angle = Rational(quarter) + Rational(off) * Rational(side);
          const Turn turn = nearest_turn(angle, tolerance);
          EXPECT_LE(turn.off, tolerance);
          EXPECT_LE(std::abs(turn.degrees - angle.to_double()), tolerance + 1e-10);
          EXPECT_GE(turn.tan_half, Rational(0));
          EXPECT_LT(turn.tan_half, Rational(1));
        }
      }
    }
  }
}

TEST(Turn, BadInput) {
  EXPECT_THROW((void)full_turn(0), Error);
  for (const double tolerance : {0.0, -1.0, 1.1, 9e-11, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW((void)nearest_turn(1, tolerance), Error);
  }
  EXPECT_THROW((void)nearest_turn(1000001), Error);
  EXPECT_THROW((void)nearest_turn(-1000001), Error);
  EXPECT_EQ(nearest_turn(1000000).quarters, 1000000 / 90 % 4);
}

}  // namespace
}  // namespace minksum

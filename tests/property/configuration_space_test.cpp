// Slices of configuration spaces, against collision tests of the placed robot and by law.
#include "minksum/configuration_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "minksum/boolean.hpp"
#include "minksum/locate.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

Geometry as_geometry(const Region& region) { return {region, {}, {}}; }

/// A multiple of a quarter, half, tenth, or any degree.
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

/// What the slice is about: the robot, turned about its reference point, which is at `at`.
Region placed(const Region& robot, const Point& reference, const Turn& turn, const Point& at) {
  const Affine home = Affine::translation(-reference.x, -reference.y);
  return transform(robot, Affine::translation(at.x, at.y).after(turn.map()).after(home));
}

Point between(const Point& a, const Point& b, const Rational& t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

/// Points on the thin and areal parts' boundaries, and any of the box.
std::vector<Point> places_to_try(Random& random, const Slice& slice, const Box& box, int count) {
  std::vector<Point> points;
  const Region& free = slice.free.region;
  for (std::size_t v = 0; v < free.vertex_count(); ++v) points.push_back(free.point(v));
  for (const Point& point : slice.free.points) points.push_back(point);
  for (const Polyline& line : slice.free.polylines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      points.push_back(between(line[i], line[i + 1], Rational(random.below(8), 7)));
    }
  }
  if (points.size() > static_cast<std::size_t>(count) / 4) {
    points.resize(static_cast<std::size_t>(count) / 4);
  }
  while (points.size() < static_cast<std::size_t>(count)) {
    points.push_back({box.min.x + (box.max.x - box.min.x) * Rational(random.below(1001), 1000),
                      box.min.y + (box.max.y - box.min.y) * Rational(random.below(1001), 1000)});
  }
  return points;
}

struct Scene {
  Region robot;
  Region obstacles;
  Rational angle;
  ConfigurationOptions options;
};

Scene random_scene(Random& random) {
  Scene scene;
  scene.robot = test::random_region(random);
  scene.obstacles = test::scaled(test::random_region(random), Rational(random.between(1, 4)));
  scene.angle = random_angle(random);
  scene.options.tight = true;
  if (random.one_in(4)) {  // often one that fits into the other with no play
    const test::Pair pair = test::random_pair(random);
    scene.obstacles = pair.p;
    scene.robot = reflect(pair.q);
    scene.angle = 0;
    return scene;
  }
  if (random.one_in(2)) {
    scene.options.reference = {Rational(random.between(-9, 30), 2), Rational(random.below(9), 3)};
  }
  if (random.one_in(2)) {
    const Region room = test::scaled(test::random_region(random), Rational(random.between(2, 8)));
    scene.options.workspace = as_geometry(room);
  }
  return scene;
}

// MINKSUM_PAIRS counts scenes; 50 configurations each.
TEST(ConfigurationSpace, AgreesWithCollisionTests) {
  const std::uint64_t seed = test::seed_from_environment(1);
  SCOPED_TRACE(seed);
  Random random(seed);
  const int scenes = test::count_from_environment(80);
  constexpr int kPlaces = 50;
  int free_places = 0;
  int thin_places = 0;
  for (int i = 0; i < scenes; ++i) {
    const Scene scene = random_scene(random);
    const ConfigurationSpace space(as_geometry(scene.robot), as_geometry(scene.obstacles),
                                   scene.options);
    const Slice slice = space.slice(nearest_turn(scene.angle), true);
    const PointLocator free(slice.free);
    const PointLocator area({slice.free.region, {}, {}});
    const PointLocator obstacles(slice.obstacles);
    for (const Point& at : places_to_try(random, slice, space.boundary(), kPlaces)) {
      const Region robot = placed(scene.robot, scene.options.reference, slice.turn, at);
      const auto& room = scene.options.workspace;
      const bool collides = !intersect(scene.obstacles, robot).empty() ||
                            (room && !contains(resolve(*room).region, robot));
      const bool found_free = free.locate(at) != Location::kOutside;
      ASSERT_EQ(found_free, !collides)
          << test::to_text(scene.robot) << '\n' << test::to_text(scene.obstacles) << '\n'
          << slice.turn.asked << ' ' << at.x << ' ' << at.y;
      // Free space and obstacles share no more than their boundaries, and the thin parts.
      const bool thin = found_free && area.locate(at) == Location::kOutside;
      if (!thin) {
        EXPECT_EQ(found_free, obstacles.locate(at) != Location::kInside);
      }
      free_places += found_free ? 1 : 0;
      thin_places += thin ? 1 : 0;
    }
  }
  EXPECT_GT(free_places, scenes * kPlaces / 10);
  EXPECT_LT(free_places, scenes * kPlaces * 9 / 10);
  if (scenes >= 80) {
    EXPECT_GT(thin_places, 0);
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

// The reference point is an offset, whatever the turn.
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
    const Rational& reach = space.reach();
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
    const Geometry mirrored = transform(
        as_geometry(robot), Affine::scaling(Rational(-1)).after(slice.turn.map()));
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
  EXPECT_EQ(space.reach(), Rational(5));
}

// Squares of its coordinates are beyond all doubles.
TEST(ConfigurationSpace, RobotsOfAnySize) {
  const Region square = test::rectangle(0, 0, 1, 1);
  for (const int exponent : {-300, 300}) {
    const Rational size(Decimal{1, exponent});
    const Region robot = test::scaled(square, size);
    const ConfigurationSpace space(as_geometry(robot), as_geometry(square));
    EXPECT_GE(space.reach() * space.reach(), size * size * Rational(2));
    EXPECT_LE(space.reach(), size * Rational(3, 2));
    EXPECT_EQ(space.slice(nearest_turn(0)).obstacles.region,
              minkowski_sum(square, reflect(robot)));
  }
}

TEST(ConfigurationSpace, ThreadsGiveSlicesInOrder) {
  Random random(5);
  const Region robot = test::random_two_opt(random, 12, 20);
  const Region obstacles = test::random_with_holes(random, 90, 3);
  ConfigurationOptions options;
  std::vector<Slice> expected;
  const std::vector<Turn> turns = full_turn(50);
  for (const int threads : {1, 2, 7, 100}) {
    options.threads = threads;
    const ConfigurationSpace space(as_geometry(robot), as_geometry(obstacles), options);
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

// Whatever is thrown, by whom, arrives, and the first in order.
TEST(ConfigurationSpace, FailuresOfThreads) {
  ConfigurationOptions options;
  const Geometry square = as_geometry(test::rectangle(0, 0, 9, 9));
  const std::vector<Turn> turns = full_turn(30);
  for (const int threads : {1, 3}) {
    options.threads = threads;
    const ConfigurationSpace space(square, square, options);
    const auto throw_at = [](std::size_t from) {
      return [from](std::size_t i, Slice&) {
        if (i >= from) throw std::runtime_error(std::to_string(i));
      };
    };
    const auto nothing = [](std::size_t, Slice&) {};
    for (const std::size_t from : {0U, 7U, 29U}) {
      for (const bool in_finish : {true, false}) {
        try {
          space.for_each_slice(turns, false,
                               in_finish ? std::function<void(std::size_t, Slice&)>(throw_at(from))
                                         : nothing,
                               in_finish ? std::function<void(std::size_t, Slice&)>(nothing)
                                         : throw_at(from));
          FAIL();
        } catch (const std::runtime_error& error) {
          EXPECT_EQ(error.what(), std::to_string(from));
        }
      }
    }
  }
}

TEST(ConfigurationSpace, CanBeCancelled) {
  ConfigurationOptions options;
  options.threads = 2;
  options.cancel.emplace();
  const Geometry square = as_geometry(test::rectangle(0, 0, 9, 9));
  const ConfigurationSpace space(square, square, options);
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
                                 const ConfigurationOptions& options, int operand) {
    try {
      const ConfigurationSpace space(robot, obstacles, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
      EXPECT_EQ(error.culprit().operand, operand);
    }
  };
  ConfigurationOptions options;
  expect_refused(line, square, options, 0);
  expect_refused({}, square, options, 0);
  options.workspace = line;
  expect_refused(square, square, options, 2);
  options.workspace.reset();
  // Where it has no play among lines is not known.
  options.tight = true;
  expect_refused(square, line, options, 1);
  expect_refused(square, {{}, {}, {{0, 0}}}, options, 1);
  options.tight = false;
  options.fill = FillRule::kStrict;
  expect_refused(bow, square, options, 0);
  expect_refused(square, bow, options, 1);
  options.workspace = bow;
  expect_refused(square, square, options, 2);
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
    // No smaller denominator has a fraction that is clearly within the tolerance.
    const auto q = static_cast<std::int64_t>(turn.tan_half.denominator().to_double());
    const double inner = tolerance * 0.999999;
    for (std::int64_t smaller = 1; smaller < q; ++smaller) {
      const auto size = static_cast<double>(smaller);
      const double low = std::max(0.0, tangent((rest - inner) / 2)) * size;
      EXPECT_GT(std::ceil(low), tangent((rest + inner) / 2) * size) << angle << ' ' << smaller;
    }
    // It turns by what it says.
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

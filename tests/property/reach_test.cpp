// Paths of robots: each move swept and tested for collisions, answers against a graph of all parts.
#include "minksum/reach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "minksum/boolean.hpp"
#include "minksum/locate.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

Geometry as_geometry(const Region& region) { return {region, {}, {}}; }

struct Scene {
  Region robot;
  Geometry obstacles;
  ReachOptions options;

  [[nodiscard]] Reach from_to(const Configuration& from, const Configuration& to) const {
    return reach(as_geometry(robot), obstacles, from, to, options);
  }
  [[nodiscard]] Region placed(const Turn& turn, const Point& at) const {
    const Affine home = Affine::translation(-options.reference.x, -options.reference.y);
    return transform(robot, Affine::translation(at.x, at.y).after(turn.map()).after(home));
  }
  [[nodiscard]] bool is_free(const Region& where) const {
    if (!intersect(obstacles.region, where).empty()) return false;
    return !options.workspace || contains(options.workspace->region, where);
  }
};

/// What the robot touches while it moves from a to b.
Region swept(const Scene& scene, const Turn& turn, const Point& a, const Point& b) {
  const Geometry way{{}, {{{0, 0}, {b.x - a.x, b.y - a.y}}}, {}};
  return minkowski_sum(as_geometry(scene.placed(turn, a)), way).region;
}

/// The angle of a turn, 0 to 360.
double angle_of(const Turn& turn) {
  return 90 * turn.quarters + 2 * std::atan(turn.tan_half.to_double()) * 180 / 3.14159265358979;
}

void expect_turns_freely(const Scene& scene, const Turn& a, const Turn& b, const Point& at) {
  const double step = std::remainder(angle_of(b) - angle_of(a), 360);
  EXPECT_LE(std::abs(step), 360.0 / static_cast<double>(scene.options.angles) + 0.01);
  for (int i = 1; i < 8 && scene.options.certain; ++i) {
    const Turn between = nearest_turn(Rational(angle_of(a) + step * i / 8), 1e-6);
    EXPECT_TRUE(scene.is_free(scene.placed(between, at)));
  }
}

void expect_good_path(const Scene& scene, const Configuration& from, const Configuration& to,
                      const Reach& found) {
  ASSERT_TRUE(found.reachable);
  ASSERT_FALSE(found.path.empty());
  const Waypoint& first = found.path.front();
  const Waypoint& last = found.path.back();
  EXPECT_EQ(first.at, from.at);
  EXPECT_EQ(last.at, to.at);
  EXPECT_TRUE(first.turn.same_as(nearest_turn(from.degrees)));
  EXPECT_TRUE(last.turn.same_as(nearest_turn(to.degrees)));
  EXPECT_TRUE(scene.is_free(scene.placed(first.turn, first.at)));
  for (std::size_t i = 1; i < found.path.size(); ++i) {
    const Waypoint& a = found.path[i - 1];
    const Waypoint& b = found.path[i];
    if (a.turn.same_as(b.turn)) {
      EXPECT_FALSE(a.at == b.at);
      EXPECT_TRUE(scene.is_free(swept(scene, a.turn, a.at, b.at))) << i;
    } else {
      EXPECT_EQ(a.at, b.at);
      EXPECT_TRUE(scene.is_free(scene.placed(b.turn, b.at))) << i;
      expect_turns_freely(scene, a.turn, b.turn, a.at);
    }
  }
}

/// A room of 40 × 20 that a wall divides, but for a door of this width.
Scene two_rooms(const Region& robot, const Rational& door) {
  const Rational low = (Rational(20) - door) * Rational(1, 2);
  const Rational high = Rational(20) - low;
  const Polygon walls[] = {{{{19, 0}, {21, 0}, {21, low}, {19, low}}, {}},
                           {{{19, high}, {21, high}, {21, 20}, {19, 20}}, {}}};
  Scene scene;
  scene.robot = robot;
  scene.obstacles = as_geometry(Region(walls));
  scene.options.workspace = as_geometry(test::rectangle(0, 0, 40, 20));
  scene.options.angles = 24;
  return scene;
}

TEST(Reach, ThroughADoor) {
  const Region rod = test::moved(test::rectangle(0, 0, 10, 1), -5, Rational(-1, 2));
  const Configuration from{{6, 10}, 90};
  const Configuration to{{34, 10}, 270};
  for (const bool certain : {false, true}) {
    Scene scene = two_rooms(rod, 5);
    scene.options.certain = certain;
    expect_good_path(scene, from, to, scene.from_to(from, to));
    expect_good_path(scene, to, from, scene.from_to(to, from));
    scene = two_rooms(rod, Rational(9, 10));
    scene.options.certain = certain;
    EXPECT_FALSE(scene.from_to(from, to).reachable);
  }
  // A hair more than its own width is enough, and just its width leaves no play.
  for (const int more : {-1, 0, 1}) {
    const Scene scene = two_rooms(rod, Rational(1) + Rational(more, 1'000'000'000));
    const Reach found = scene.from_to(from, to);
    EXPECT_EQ(found.reachable, more == 1);
    if (more == 1) expect_good_path(scene, from, to, found);
  }
  // It has to turn: with one angle it cannot.
  for (const std::size_t angles : {std::size_t{1}, std::size_t{4}}) {
    Scene scene = two_rooms(test::turned(rod), 5);
    scene.options.angles = angles;
    EXPECT_EQ(scene.from_to({{6, 10}, 0}, {{34, 10}, 0}).reachable, angles == 4);
    scene.robot = rod;
    EXPECT_TRUE(scene.from_to({{6, 10}, 0}, {{34, 10}, 0}).reachable);
  }
}

// The free space of two slices has only slivers in common, one above the other, far apart.
TEST(Reach, ByWayOfSlivers) {
  const Polygon obstacles[] = {
      {{{24, 79}, {36, 61}, {42, 49}, {49, 52}, {39, 61}, {53, 74}, {35, 72}, {40, 64}}, {}},
      {{{51, 49},
        {58, 40},
        {54, 20},
        {60, 30},
        {Rational(1212, 17), Rational(3474, 119)},
        {65, 22},
        {60, 19},
        {56, 6},
        {71, 13},
        {76, 5},
        {80, 19},
        {80, 28},
        {Rational(512, 7), Rational(208, 7)},
        {62, 39},
        {80, 42},
        {73, 47}},
       {}},
      {{{55, 56}, {62, 56}, {62, 85}, {55, 85}}, {}}};
  Scene scene;
  scene.robot = test::make_polygon({{0, 0}, {14, 0}, {1, 1}, {0, 7}});
  scene.obstacles = as_geometry(Region(obstacles));
  scene.options.angles = 12;
  const Configuration from{{13, -3}, 70};
  const Configuration to{{-1, 36}, 173};
  expect_good_path(scene, from, to, scene.from_to(from, to));
}

// With a margin for all angles between, a narrow door is too narrow; with more angles it is not.
TEST(Reach, CertainNeedsRoomOrAngles) {
  const Region rod = test::moved(test::rectangle(0, 0, 10, 1), -5, Rational(-1, 2));
  const Configuration from{{6, 10}, 0};
  const Configuration to{{34, 10}, 0};
  Scene scene = two_rooms(rod, Rational(3, 2));
  EXPECT_TRUE(scene.from_to(from, to).reachable);
  scene.options.certain = true;
  EXPECT_FALSE(scene.from_to(from, to).reachable);
  scene.options.angles = 180;
  const Reach found = scene.from_to(from, to);
  expect_good_path(scene, from, to, found);
  EXPECT_GT(found.margin, Rational(1, 100));
  EXPECT_LT(found.margin, Rational(1, 10));
}

// Lines of no width on both sides, and a point between the halves of the robot: it touches them.
TEST(Reach, FromWallsWithoutPlay) {
  Scene scene;
  scene.robot = test::make_region({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
                                   {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}});
  scene.obstacles.polylines = {{{-1, 0}, {1, 0}}, {{1, 1}, {9, 1}}, {{0, 2}, {2, 2}}};
  scene.obstacles.points = {{0, 1}};
  scene.options.angles = 4;
  const Configuration between{{0, 0}, 0};
  const Configuration outside{{0, 5}, 0};
  EXPECT_FALSE(scene.from_to(between, outside).reachable);
  EXPECT_FALSE(scene.from_to(outside, between).reachable);
}

TEST(Reach, AroundEverything) {
  Scene scene;
  scene.robot = test::make_polygon({{-1, -1}, {3, -1}, {-1, 2}});
  scene.obstacles = as_geometry(test::rectangle(0, -50, 10, 50));
  scene.options.angles = 12;
  const Configuration from{{-9, 0}, 17};
  const Configuration to{{30, Rational(1, 3)}, 211};
  expect_good_path(scene, from, to, scene.from_to(from, to));
  scene.obstacles = {};
  expect_good_path(scene, from, to, scene.from_to(from, to));
  const Reach there = scene.from_to(from, from);
  EXPECT_EQ(there.path.size(), 1U);
  EXPECT_EQ(there.slices, 13U);
  // Closed in on all sides: it turns, but stays.
  scene.obstacles = as_geometry(test::frame({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}, 2));
  expect_good_path(scene, {{0, 0}, 0}, {{2, 1}, 180}, scene.from_to({{0, 0}, 0}, {{2, 1}, 180}));
  EXPECT_FALSE(scene.from_to({{0, 0}, 0}, {{99, 0}, 0}).reachable);
}

TEST(Reach, LongWays) {
  Scene scene;
  scene.robot = test::rectangle(0, 0, 1, 1);
  scene.obstacles = as_geometry(test::scaled(test::spiral(6), Rational(4)));
  scene.options.angles = 4;
  const Box box = *bounding_box(scene.obstacles.region);
  const ConfigurationSpace space(as_geometry(scene.robot), scene.obstacles, scene.options);
  // From far outside to wherever is free inside.
  const Configuration from{{box.min.x - Rational(5), box.min.y - Rational(5)}, 0};
  const PointLocator free(space.slice(nearest_turn(0), true).free);
  int reached = 0;
  for (int i = 1; i < 8; ++i) {
    const Rational t(i, 8);
    const Configuration to{{box.min.x + (box.max.x - box.min.x) * t,
                            box.min.y + (box.max.y - box.min.y) * Rational(1, 2)}, 90};
    const Configuration same{to.at, 0};
    if (free.locate(to.at) != Location::kInside) continue;
    const Reach found = scene.from_to(from, same);
    if (!found.reachable) continue;
    ++reached;
    expect_good_path(scene, from, same, found);
  }
  EXPECT_GT(reached, 0);
}

/// Whether two configurations are connected, by a graph of all pairs of parts.
class AllPairs {
 public:
  AllPairs(const Scene& scene, const Configuration& from, const Configuration& to) {
    ConfigurationSpace space(as_geometry(scene.robot), scene.obstacles, scene.options);
    space.include(from.at);
    space.include(to.at);
    std::vector<Turn> turns = full_turn(scene.options.angles);
    std::vector<std::size_t> first{0};
    for (const Turn& turn : turns) {
      const Region free = space.slice(turn, true).free.region;
      for (const std::size_t p : free.polygons()) parts_.emplace_back(free.polygon(p));
      first.push_back(parts_.size());
    }
    of_.resize(parts_.size());
    std::iota(of_.begin(), of_.end(), 0U);
    for (std::size_t s = 0; s < turns.size(); ++s) {
      const std::size_t t = (s + 1) % turns.size();
      for (std::size_t a = first[s]; a < first[s + 1]; ++a) {
        for (std::size_t b = first[t]; b < first[t + 1]; ++b) {
          if (!intersect(parts_[a], parts_[b]).empty()) of_[root(a)] = root(b);
        }
      }
    }
    const auto ends = [&](const Configuration& end) {
      std::vector<std::size_t> found;
      for (std::size_t s = 0; s < turns.size(); ++s) {
        if (!turns[s].same_as(nearest_turn(end.degrees))) continue;
        for (std::size_t a = first[s]; a < first[s + 1]; ++a) {
          if (PointLocator(as_geometry(parts_[a])).locate(end.at) != Location::kOutside) {
            found.push_back(root(a));
          }
        }
      }
      return found;
    };
    for (const std::size_t a : ends(from)) {
      for (const std::size_t b : ends(to)) connected_ |= a == b;
    }
  }
  [[nodiscard]] bool connected() const { return connected_; }

 private:
  std::size_t root(std::size_t i) {
    while (of_[i] != i) i = of_[i];
    return i;
  }
  std::vector<Region> parts_;
  std::vector<std::size_t> of_;
  bool connected_ = false;
};

TEST(Reach, IsWhatTheGraphOfAllPartsSays) {
  const std::uint64_t seed = test::seed_from_environment(1);
  SCOPED_TRACE(seed);
  Random random(seed);
  int yes = 0;
  int no = 0;
  const int count = test::count_from_environment(60);
  for (int i = 0; yes + no < count && i < 20 * count; ++i) {
    Scene scene;
    scene.robot = test::random_region(random);
    scene.obstacles =
        resolve(as_geometry(test::scaled(test::random_region(random), Rational(3))));
    scene.options.angles = 8;
    if (random.one_in(2)) {
      scene.options.reference = {Rational(random.below(9)), Rational(random.below(9))};
    }
    const auto end = [&] {
      return Configuration{{Rational(random.between(-40, 120), 2),
                            Rational(random.between(-40, 120), 2)}, 45 * random.below(8)};
    };
    const Configuration from = end();
    const Configuration to = end();
    const auto is_free = [&](const Configuration& c) {
      return scene.is_free(scene.placed(nearest_turn(c.degrees), c.at));
    };
    if (!is_free(from) || !is_free(to)) {
      EXPECT_THROW((void)scene.from_to(from, to), Error);
      continue;
    }
    const Reach found = scene.from_to(from, to);
    EXPECT_EQ(found.reachable, AllPairs(scene, from, to).connected())
        << test::to_text(scene.robot) << '\n' << test::to_text(scene.obstacles.region);
    if (found.reachable) expect_good_path(scene, from, to, found);
    ++(found.reachable ? yes : no);
  }
  EXPECT_GE(yes + no, count);
  EXPECT_GT(yes, 0);
}

TEST(Reach, BadInput) {
  const Region rod = test::moved(test::rectangle(0, 0, 10, 1), -5, Rational(-1, 2));
  const Configuration free{{6, 10}, 0};
  const auto expect_refused = [&](Scene scene, const Configuration& from, const Configuration& to,
                                  int operand, const std::string& words) {
    SCOPED_TRACE(words);
    try {
      (void)scene.from_to(from, to);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
      EXPECT_EQ(error.culprit().operand, operand);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  Scene scene = two_rooms(rod, 5);
  expect_refused(scene, {{20, 5}, 0}, free, 3, "overlaps an obstacle at the start");
  expect_refused(scene, free, {{20, 5}, 0}, 4, "overlaps an obstacle at the goal");
  expect_refused(scene, {{4, 5}, 0}, free, 3, "leaves the workspace at the start");
  expect_refused(scene, free, {{-99, 0}, 0}, 4, "leaves the workspace at the goal");
  scene.obstacles.polylines.push_back({{30, 1}, {30, 19}});
  expect_refused(scene, free, {{30, 10}, 0}, 4, "overlaps an obstacle at the goal");
  scene.options.angles = 0;
  expect_refused(scene, free, free, -1, "at least one angle");
  scene.options.angles = 2;
  scene.options.certain = true;
  expect_refused(scene, free, free, -1, "more angles");
}

}  // namespace
}  // namespace minksum

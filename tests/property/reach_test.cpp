// Tests paths of robots: each move is swept and tested for collisions, and answers are compared
// with a graph of all parts.
#include "minksum/reach.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "minksum/locate.hpp"
#include "property/reach_judge.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/robot_scenes.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::as_geometry;
using test::Judge;
using test::Random;
using Scene = test::ReachScene;

void expect_good_path(const Scene& scene, const Configuration& from, const Configuration& to,
                      const Reach& found) {
  Judge(scene, from, to).expect_good_path(found);
}

/// Returns a room of 40 × 20 that a wall with a door of this width divides.
Scene two_rooms(const Region& robot, const Rational& door) {
  const Rational low = (Rational(20) - door) * Rational(1, 2);
  const Rational high = Rational(20) - low;
  const Polygon walls[] = {{{{19, 0}, {21, 0}, {21, low}, {19, low}}, {}},
                           {{{19, high}, {21, high}, {21, 20}, {19, 20}}, {}}};
  Scene scene;
  scene.robot = robot;
  scene.obstacles = as_geometry(Region(walls));
  scene.setting.workspace = as_geometry(test::rectangle(0, 0, 40, 20));
  scene.setting.angles = 24;
  return scene;
}

TEST(Reach, ThroughADoor) {
  const Region rod = test::moved(test::rectangle(0, 0, 10, 1), -5, Rational(-1, 2));
  const Configuration from{{6, 10}, 90};
  const Configuration to{{34, 10}, 270};
  for (const bool certain : {false, true}) {
    Scene scene = two_rooms(rod, 5);
    scene.setting.certain = certain;
    expect_good_path(scene, from, to, scene.from_to(from, to));
    expect_good_path(scene, to, from, scene.from_to(to, from));
    scene = two_rooms(rod, Rational(9, 10));
    scene.setting.certain = certain;
    EXPECT_FALSE(scene.from_to(from, to).reachable);
  }
  // A hair more than the rod's width is enough, and exactly its width leaves no play.
  for (const int more : {-1, 0, 1}) {
    const Scene scene = two_rooms(rod, Rational(1) + Rational(more, 1'000'000'000));
    const Reach found = scene.from_to(from, to);
    EXPECT_EQ(found.reachable, more == 1);
    if (more == 1) expect_good_path(scene, from, to, found);
  }
  // The rod has to turn, so one angle is not enough.
  for (const std::size_t angles : {std::size_t{1}, std::size_t{4}}) {
    Scene scene = two_rooms(test::turned(rod), 5);
    scene.setting.angles = angles;
    EXPECT_EQ(scene.from_to({{6, 10}, 0}, {{34, 10}, 0}).reachable, angles == 4);
    scene.robot = rod;
    EXPECT_TRUE(scene.from_to({{6, 10}, 0}, {{34, 10}, 0}).reachable);
  }
}

// The free spaces of two slices share only slivers that lie far apart, one above the other.
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
  scene.setting.angles = 12;
  const Configuration from{{13, -3}, 70};
  const Configuration to{{-1, 36}, 173};
  expect_good_path(scene, from, to, scene.from_to(from, to));
}

// With a margin for all angles between, a narrow door is too narrow; more angles mend that.
TEST(Reach, CertainNeedsRoomOrAngles) {
  const Region rod = test::moved(test::rectangle(0, 0, 10, 1), -5, Rational(-1, 2));
  const Configuration from{{6, 10}, 0};
  const Configuration to{{34, 10}, 0};
  Scene scene = two_rooms(rod, Rational(3, 2));
  EXPECT_TRUE(scene.from_to(from, to).reachable);
  scene.setting.certain = true;
  EXPECT_FALSE(scene.from_to(from, to).reachable);
  scene.setting.angles = 180;
  const Reach found = scene.from_to(from, to);
  expect_good_path(scene, from, to, found);
  EXPECT_GT(found.margin, Rational(1, 100));
  EXPECT_LT(found.margin, Rational(1, 10));
}

// The robot touches lines on both sides, and a point between its halves.
TEST(Reach, FromWallsWithoutPlay) {
  Scene scene;
  scene.robot =
      test::make_region({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}});
  scene.obstacles.polylines = {{{-1, 0}, {1, 0}}, {{1, 1}, {9, 1}}, {{0, 2}, {2, 2}}};
  scene.obstacles.points = {{0, 1}};
  scene.setting.angles = 4;
  const Configuration between{{0, 0}, 0};
  const Configuration outside{{0, 5}, 0};
  EXPECT_FALSE(scene.from_to(between, outside).reachable);
  EXPECT_FALSE(scene.from_to(outside, between).reachable);
  EXPECT_EQ(scene.from_to(between, between).path.size(), 1U);
}

// Two corners leave just the robot's width along the diagonal. All slices have the same two free
// parts, which touch at one point.
TEST(Reach, NotByWayOfAPoint) {
  for (const int more : {0, 1}) {
    const Rational right(7'000'000 + more, 1'000'000);
    const Polygon walls[] = {{{{0, 4}, {5, 4}, {5, 5}, {0, 5}}, {}},
                             {{{right, 7}, {12, 7}, {12, 8}, {right, 8}}, {}}};
    Scene scene;
    scene.robot = test::rectangle(-1, -1, 1, 1);
    scene.obstacles = as_geometry(Region(walls));
    scene.setting.workspace = as_geometry(test::rectangle(0, 0, 12, 12));
    scene.setting.angles = 4;
    for (const Configuration& to : {Configuration{{3, 10}, 0}, Configuration{{6, 6}, 180}}) {
      const Configuration from{{9, 2}, 90};
      const bool at_point = to.degrees == Rational(180);
      EXPECT_EQ(scene.from_to(from, to).reachable, at_point || more == 1);
      EXPECT_EQ(scene.from_to(to, from).reachable, at_point || more == 1);
    }
  }
}

// The corridor leaves the robot about 20 degrees to turn, so the only way passes 0.
TEST(Reach, TurnsPastZero) {
  Scene scene;
  scene.robot = test::moved(test::rectangle(0, 0, 10, 1), -5, Rational(-1, 2));
  scene.setting.workspace = as_geometry(test::rectangle(0, 0, 40, 5));
  scene.setting.angles = 18;
  const Rational middle(5, 2);
  const Configuration from{{20, middle}, 340};
  const Configuration to{{22, middle}, 20};
  expect_good_path(scene, from, to, scene.from_to(from, to));
  expect_good_path(scene, to, from, scene.from_to(to, from));
}

TEST(Reach, AroundEverything) {
  Scene scene;
  scene.robot = test::make_polygon({{-1, -1}, {3, -1}, {-1, 2}});
  scene.obstacles = as_geometry(test::rectangle(0, -50, 10, 50));
  scene.setting.angles = 12;
  const Configuration from{{-9, 0}, 17};
  const Configuration to{{30, Rational(1, 3)}, 211};
  expect_good_path(scene, from, to, scene.from_to(from, to));
  scene.obstacles = {};
  expect_good_path(scene, from, to, scene.from_to(from, to));
  const Reach there = scene.from_to(from, from);
  EXPECT_EQ(there.path.size(), 1U);
  EXPECT_EQ(there.slices, 13U);
  // The robot is closed in on all sides, so it can turn but not move.
  scene.obstacles = as_geometry(test::frame({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}, 2));
  expect_good_path(scene, {{0, 0}, 0}, {{2, 1}, 180}, scene.from_to({{0, 0}, 0}, {{2, 1}, 180}));
  EXPECT_FALSE(scene.from_to({{0, 0}, 0}, {{99, 0}, 0}).reachable);
}

TEST(Reach, LongWays) {
  Scene scene;
  scene.robot = test::rectangle(0, 0, 1, 1);
  scene.obstacles = as_geometry(test::scaled(test::spiral(6), Rational(4)));
  scene.setting.angles = 4;
  const Box box = *bounding_box(scene.obstacles.region);
  const ConfigurationSpace space(as_geometry(scene.robot), scene.obstacles, scene.setting);
  // The searches go from far outside to free points inside.
  const Configuration from{{box.min.x - Rational(5), box.min.y - Rational(5)}, 0};
  const PointLocator free(space.slice(nearest_turn(0), true).free);
  int reached = 0;
  for (int i = 1; i < 8; ++i) {
    const Rational t(i, 8);
    const Configuration to{{box.min.x + (box.max.x - box.min.x) * t,
                            box.min.y + (box.max.y - box.min.y) * Rational(1, 2)},
                           90};
    const Configuration same{to.at, 0};
    if (free.locate(to.at) != Location::kInside) continue;
    const Reach found = scene.from_to(from, same);
    if (!found.reachable) continue;
    ++reached;
    expect_good_path(scene, from, same, found);
  }
  EXPECT_GT(reached, 0);
}

/// Counts searches by their ends.
struct Tally {
  int yes = 0;
  int no = 0;
  int refused = 0;
};

Scene scene_of(Random& random, const test::RobotScene& made) {
  Scene scene{made.robot, made.obstacles, {}};
  static_cast<ConfigurationOptions&>(scene.setting) = made.setting;
  scene.setting.angles = made.angles;
  scene.setting.tolerance = made.tolerance;
  scene.setting.certain = random.one_in(3);
  return scene;
}

/// Returns the angle of the turn in which the robot may have no play, of another slice, or any
/// angle.
Rational random_degrees(Random& random, const Scene& scene, const Turn& turn) {
  const auto angles = static_cast<int>(scene.setting.angles);
  switch (random.below(4)) {
    case 0:
      return Rational(360 * random.below(angles), angles);
    case 1:
      return Rational(random.between(-4000, 4000), 10);
    default:
      return turn.asked;
  }
}

/// Makes a few tries for places that are free, mostly with contact.
void find_places(Random& random, const test::RobotScene& made, const Scene& scene,
                 Configuration& from, Configuration& to) {
  const Judge judge(scene, from, to);
  const auto find = [&](Configuration& end) {
    const Waypoint any = &end == &from ? judge.from() : judge.to();
    const Slice slice = judge.space().slice(any.turn, true);
    const ConfigurationSpace near(as_geometry(scene.robot), scene.obstacles, scene.setting);
    for (int i = 0; i < 10; ++i) {
      end.at = test::random_place(random, made, slice, near.boundary());
      if (judge.at({end.at, any.turn}) == reference::Collision::kNone) return;
    }
  };
  find(from);
  find(to);
}

void expect_refused(const Scene& scene, const Judge& judge, const Configuration& from,
                    const Configuration& to) {
  using reference::Collision;
  const bool at_start = judge.at(judge.from()) != Collision::kNone;
  const Collision collision = judge.at(at_start ? judge.from() : judge.to());
  try {
    (void)scene.from_to(from, to);
    FAIL() << "a robot that is not free was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.culprit().operand, at_start ? 3 : 4);
    const char* words =
        collision == Collision::kWorkspace ? "leaves the workspace" : "overlaps an obstacle";
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

Reach answer(const Scene& scene, const Configuration& from, const Configuration& to) {
  try {
    return scene.from_to(from, to);
  } catch (const Error& error) {
    ADD_FAILURE() << error.what();
    return {};
  }
}

void expect_right_answer(Random& random, const test::RobotScene& made, const Scene& scene,
                         Tally& tally) {
  Configuration from{{0, 0}, random_degrees(random, scene, made.turn)};
  Configuration to{{0, 0}, random_degrees(random, scene, made.turn)};
  find_places(random, made, scene, from, to);
  if (random.one_in(8)) to = from;
  std::ostringstream ends;
  ends << from.at.x << ' ' << from.at.y << ' ' << from.degrees << " to " << to.at.x << ' '
       << to.at.y << ' ' << to.degrees << (scene.setting.certain ? " certain" : "");
  SCOPED_TRACE(ends.str());
  Judge judge(scene, from, to);
  if (judge.at(judge.from()) != reference::Collision::kNone ||
      judge.at(judge.to()) != reference::Collision::kNone) {
    ++tally.refused;
    expect_refused(scene, judge, from, to);
    return;
  }
  const Reach found = answer(scene, from, to);
  const Reach back = answer(scene, to, from);
  EXPECT_EQ(found.reachable, judge.connected());
  EXPECT_EQ(back.reachable, found.reachable);
  ++(found.reachable ? tally.yes : tally.no);
  if (found.reachable) judge.expect_good_path(found);
  if (back.reachable) expect_good_path(scene, to, from, back);
}

// MINKSUM_PAIRS is the number of scenes. Other tests test the free space of slices.
TEST(Reach, IsWhatTheGraphOfAllPartsSays) {
  const std::uint64_t seed = test::seed_from_environment(1);
  SCOPED_TRACE(seed);
  Random random(seed);
  Tally tally;
  const int count = test::count_from_environment(150);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const test::RobotScene made = test::random_robot_scene(random);
    SCOPED_TRACE(test::to_text(made));
    expect_right_answer(random, made, scene_of(random, made), tally);
  }
  EXPECT_GT(tally.yes, count / 10);
  EXPECT_GT(tally.no, count / 40);
  EXPECT_GT(tally.refused, count / 20);
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
  scene.setting.angles = 0;
  expect_refused(scene, free, free, -1, "at least one angle");
  scene.setting.angles = 2;
  scene.setting.certain = true;
  expect_refused(scene, free, free, -1, "more angles");
}

}  // namespace
}  // namespace minksum

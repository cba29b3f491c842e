#include "property/reach_judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "reference/brute_force.hpp"
#include "support/shapes.hpp"

namespace minksum::test {
namespace {

/// Returns the robot, with its reference point at the origin, ⊕ the octagon that contains a disc;
/// see `reach`.
Region grown(const Region& robot, const Point& reference, const Rational& r) {
  const Region home = moved(robot, -reference.x, -reference.y);
  if (r.sign() == 0) return home;
  const Rational s = r * Rational(5, 12);
  const Polygon octagon{{{r, -s}, {r, s}, {s, r}, {-s, r}, {-r, s}, {-r, -s}, {-s, -r}, {s, -r}},
                        {}};
  return reference::brute_force_sum(home, Region(octagon));
}

std::vector<Turn> all_turns(const ReachScene& scene, const Turn& first, const Turn& last) {
  std::vector<Turn> turns = full_turn(scene.setting.angles, scene.setting.tolerance);
  turns.push_back(first);
  turns.push_back(last);
  return reference::counter_clockwise(turns);
}

const Region* workspace_of(const ReachScene& scene) {
  return scene.setting.workspace ? &scene.setting.workspace->region : nullptr;
}

ConfigurationSpace space_of(const ReachScene& scene, const Region& robot) {
  ConfigurationOptions options = scene.setting;
  options.reference = {};
  return {{robot, {}, {}}, scene.obstacles, options};
}

}  // namespace

Judge::Judge(const ReachScene& scene, const Configuration& from, const Configuration& to,
             Turn first, Turn last)
    : from_(from),
      to_(to),
      first_(std::move(first)),
      last_(std::move(last)),
      certain_(scene.setting.certain),
      turns_(all_turns(scene, first_, last_)),
      robot_(scene.robot, scene.setting.reference, scene.obstacles, workspace_of(scene)),
      margin_(margin_of(scene)),
      grown_(grown(scene.robot, scene.setting.reference, margin_)),
      grown_robot_(grown_, {}, scene.obstacles, workspace_of(scene)),
      space_(space_of(scene, grown_)) {
  // The points give the space more room on all sides, which must not matter.
  for (const int far : {-1000, 1000}) {
    space_.include({from_.at.x + Rational(far), from_.at.y});
    space_.include({to_.at.x, to_.at.y + Rational(far)});
  }
}

/// Returns the margin that `reach` documents, with steps taken from the actual turns.
Rational Judge::margin_of(const ReachScene& scene) const {
  if (!certain_) return 0;
  const ConfigurationSpace plain({scene.robot, {}, {}}, scene.obstacles, scene.setting);
  reference::Number largest = 0;
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    const auto half =
        reference::half_step(reference::direction_of(turns_[i]),
                             reference::direction_of(turns_[(i + 1) % turns_.size()]));
    largest = std::max(largest, half.value());
  }
  return plain.radius() * reference::to_rational(largest);
}

reference::SliceGraph& Judge::graph() {
  if (!graph_) graph_.emplace(space_.slices(turns_, true));
  return *graph_;
}

bool Judge::is_free_while_turning(const Waypoint& a, const Waypoint& b) const {
  constexpr int kLooks = 10;
  for (int i = 1; i < kLooks && certain_; ++i) {
    const reference::Pt between =
        reference::turned_towards(reference::direction_of(a.turn), reference::direction_of(b.turn),
                                  reference::Number(i) / kLooks);
    if (robot_.at(reference::to_pt(a.at), between) != reference::Collision::kNone) return false;
  }
  return true;
}

void Judge::expect_good_path(const Reach& found) {
  ASSERT_TRUE(found.reachable);
  ASSERT_FALSE(found.path.empty());
  EXPECT_EQ(found.margin, margin_);
  EXPECT_EQ(found.slices, turns_.size());
  EXPECT_EQ(found.path.front().at, from_.at);
  EXPECT_EQ(found.path.back().at, to_.at);
  EXPECT_TRUE(found.path.front().turn.same_as(first_));
  EXPECT_TRUE(found.path.back().turn.same_as(last_));
  EXPECT_TRUE(is_there() ? found.path.size() == 1 : graph().has(found.path));
  EXPECT_EQ(at(found.path.front()), reference::Collision::kNone);
  for (std::size_t i = 1; i < found.path.size(); ++i) {
    const Waypoint& a = found.path[i - 1];
    const Waypoint& b = found.path[i];
    EXPECT_EQ(at(b), reference::Collision::kNone) << i;
    if (!a.turn.same_as(b.turn)) {
      EXPECT_TRUE(is_free_while_turning(a, b)) << i;
      continue;
    }
    EXPECT_TRUE(grown_robot_.is_free_along(reference::to_pt(a.at), reference::to_pt(b.at),
                                           reference::direction_of(a.turn)))
        << i;
  }
}

}  // namespace minksum::test

// Judges the results of searches for paths, by other means than the library's.
#pragma once

#include <optional>
#include <vector>

#include "minksum/reach.hpp"
#include "reference/placed_robot.hpp"
#include "reference/slice_graph.hpp"

namespace minksum::test {

struct ReachScene {
  Region robot;
  Geometry obstacles;
  ReachOptions setting;

  [[nodiscard]] Reach from_to(const Configuration& from, const Configuration& to) const {
    return reach({robot, {}, {}}, obstacles, from, to, setting);
  }
  [[nodiscard]] Turn turn_of(const Configuration& end) const {
    return nearest_turn(end.degrees, setting.tolerance);
  }
};

/// Judges one search from one configuration to another.
class Judge {
 public:
  Judge(const ReachScene& scene, const Configuration& from, const Configuration& to)
      : Judge(scene, from, to, scene.turn_of(from), scene.turn_of(to)) {}

  /// Returns the space of the robot grown by the margin, with its reference point at the origin.
  [[nodiscard]] const ConfigurationSpace& space() const { return space_; }
  [[nodiscard]] reference::Collision at(const Waypoint& waypoint) const {
    return grown_robot_.at(reference::to_pt(waypoint.at), reference::direction_of(waypoint.turn));
  }
  [[nodiscard]] Waypoint from() const { return {from_.at, first_}; }
  [[nodiscard]] Waypoint to() const { return {to_.at, last_}; }

  /// Returns whether the robot is at its goal already, which counts as reached in any case.
  [[nodiscard]] bool is_there() const {
    return from_.at == to_.at && reference::direction_of(first_) == reference::direction_of(last_);
  }
  [[nodiscard]] bool connected() { return is_there() || graph().connects(from(), to()); }
  /// Expects that each move collides nowhere. If `certain` is set, the ungrown robot must not
  /// collide at some angles between those of each turn either.
  void expect_good_path(const Reach& found);

 private:
  Judge(const ReachScene& scene, const Configuration& from, const Configuration& to, Turn first,
        Turn last);
  [[nodiscard]] Rational margin_of(const ReachScene& scene) const;
  [[nodiscard]] reference::SliceGraph& graph();
  [[nodiscard]] bool is_free_while_turning(const Waypoint& a, const Waypoint& b) const;

  Configuration from_;
  Configuration to_;
  Turn first_;
  Turn last_;
  bool certain_;
  std::vector<Turn> turns_;
  reference::PlacedRobot robot_;
  Rational margin_;
  Region grown_;
  reference::PlacedRobot grown_robot_;
  ConfigurationSpace space_;
  std::optional<reference::SliceGraph> graph_;
};

}  // namespace minksum::test

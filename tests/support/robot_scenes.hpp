// Random scenes of robots that move and turn, many of them with no room to spare.
#pragma once

#include <string>

#include "minksum/configuration_space.hpp"
#include "support/random.hpp"

namespace minksum::test {

struct RobotScene {
  Region robot;
  Geometry obstacles;            ///< its parts may overlap; its region is valid
  ConfigurationOptions options;  ///< with the reference point and, now and then, a workspace
  std::size_t angles = 1;        ///< of a full turn
  double tolerance = 1e-3;       ///< of each turn, degrees
  Turn turn;                     ///< one of these; in narrow scenes that in which the robot fits
  std::string kind;              ///< for messages

  [[nodiscard]] const Region* workspace() const {
    return options.workspace ? &options.workspace->region : nullptr;
  }
};

/// Robots of any kind, also in several parts, with holes, with the reference point far off; among
/// regions and walls at random, in workspaces at random, in a frame or a slot or a door that is in
/// one turn just as wide as the robot, a hair wider or narrower, or has room; on a grid.
[[nodiscard]] RobotScene random_robot_scene(Random& random);

/// Enough to run it again.
[[nodiscard]] std::string to_text(const RobotScene& scene);

/// A place for the robot: a vertex of a slice's free space or obstacles, or the middle of an edge,
/// where it touches; a place without play; one where a vertex of the robot is on what is in its
/// way. Now and then a hair off. Or anything in the box.
[[nodiscard]] Point random_place(Random& random, const RobotScene& scene, const Slice& slice,
                                 const Box& box);

}  // namespace minksum::test

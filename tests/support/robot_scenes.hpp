// Makes random scenes of robots that move and turn, many of them with no room to spare.
#pragma once

#include <string>

#include "minksum/configuration_space.hpp"
#include "support/random.hpp"

namespace minksum::test {

[[nodiscard]] inline Geometry as_geometry(const Region& region) { return {region, {}, {}}; }

struct RobotScene {
  Region robot;
  Geometry obstacles;            ///< its parts may overlap; its region is valid
  ConfigurationOptions setting;  ///< with the reference point and, now and then, a workspace
  bool tight = false;            ///< Options::tight
  std::size_t angles = 1;        ///< number of angles of a full turn
  double tolerance = 1e-3;       ///< tolerance of each turn, in degrees
  Turn turn;                     ///< one of the turns; in narrow scenes the robot fits in it
  std::string kind;              ///< for messages

  [[nodiscard]] const Region* workspace() const {
    return setting.workspace ? &setting.workspace->region : nullptr;
  }
};

/// Returns a scene with a robot of any kind: in several parts, with holes, or with the reference
/// point far away. Obstacles are random regions and walls, random workspaces, or squares on a grid.
/// Others are a frame, a slot or a door. In one turn these are just as wide as the robot, a hair
/// wider or narrower, or have room.
[[nodiscard]] RobotScene random_robot_scene(Random& random);

/// Returns enough of a scene to run it again.
[[nodiscard]] std::string to_text(const RobotScene& scene);

/// Returns a place for the robot. It may be a vertex of a slice's free space or obstacles, or the
/// middle of an edge, where the robot touches. It may be a place without play, one where a vertex
/// of the robot is on an obstacle, or any point of the box. Sometimes it is a hair off.
[[nodiscard]] Point random_place(Random& random, const RobotScene& scene, const Slice& slice,
                                 const Box& box);

}  // namespace minksum::test

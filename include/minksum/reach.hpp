// Whether a robot gets from one configuration to another, and how.
#pragma once

#include "minksum/configuration_space.hpp"
#include "minksum/export.h"

namespace minksum {

/// A robot's place and turn, as they are asked for.
struct Configuration {
  Point at;          ///< of the reference point
  Rational degrees;  ///< counter-clockwise
};

/// A configuration space, and how finely it is searched.
struct ReachOptions : ConfigurationOptions {
  /// The robot turns in steps of a full turn over this many.
  std::size_t angles = 72;
  double tolerance = 1e-3;  ///< of each turn, degrees; see nearest_turn
  /// Whether a path is free of collisions at all angles between two turns as well; see `reach`.
  bool certain = false;
};

/// A robot's place and turn on a path.
struct Waypoint {
  Point at;   ///< of the reference point
  Turn turn;  ///< of the robot
};

/// Whether there is a path, and which.
struct Reach {
  bool reachable = false;  ///< whether there is one
  /// From start to goal, if reachable. From one waypoint to the next the robot moves straight
  /// without turning, or turns on the spot to the neighbouring slice, the shorter way round.
  std::vector<Waypoint> path;
  std::size_t slices = 0;  ///< that were made
  std::size_t parts = 0;   ///< of free space, in all slices
  /// How much the robot was grown (`certain`), in every direction at least.
  Rational margin;
};

/// Whether `to` can be reached from `from` in the sliced free space, and a path.
///
/// There is a slice for each of setting.angles turns, and one each for the turns of both
/// configurations. The free parts of a slice (polygons of its free space) are nodes of a graph;
/// those of neighbouring slices whose insides have a point in common are joined: there the robot
/// can turn by one step. The answer is exact for this graph. Of the paths that it looks at
/// (Dijkstra 1959; by length, and for turns that of the arc at the robot's radius) it takes the
/// shortest, which need not be the shortest that there is. Each of its moves was found to lie in
/// the closed free part by exact arithmetic. It may touch obstacles. Ways that leave the robot no
/// play do not count: gaps of exactly its width, and points where two free parts touch. Where the
/// robot is already, it gets in any case.
///
/// Between two slices nothing is known, unless `certain` is set: then slices are those of the robot
/// grown by ρ = r·tan δ, with r its radius and 2δ the largest step (or δ the tolerance of an end's
/// turn, if that is more). Proof: at any angle between two neighbours, the nearer one is at most δ
/// away; a turn by δ about the reference point moves each point of the robot by at most
/// 2r·sin(δ/2) ≤ r·tan δ; so the turned robot is in the neighbour's robot ⊕ disc(ρ). The disc is
/// replaced by the octagon with the corners (±ρ, ±5ρ/12) and (±5ρ/12, ±ρ), which contains it. "No"
/// then means that there is no path for the grown robot.
///
/// Throws Error: kBadInput as ConfigurationSpace does, with culprit operand 3 if the robot is not
/// free at `from`, 4 at `to`, and if `certain` is set with steps of half a turn or more; and as
/// minkowski_sum.
[[nodiscard]] MINKSUM_API Reach reach(const Geometry& robot, const Geometry& obstacles,
                                      const Configuration& from, const Configuration& to,
                                      const ReachOptions& setting = {},
                                      const Options& options = {});

}  // namespace minksum

// Declares whether, and how, a robot gets from one configuration to another.
#pragma once

#include "minksum/configuration_space.hpp"
#include "minksum/export.h"

namespace minksum {

/// A placement and an angle of a robot, as they are asked for.
struct Configuration {
  Point at = {};          ///< position of the reference point
  Rational degrees = {};  ///< angle in degrees, counter-clockwise
};

/// What a configuration space depends on, and how finely it is searched.
struct ReachOptions : ConfigurationOptions {
  /// The number of equal steps in which the robot turns once around.
  std::size_t angles = 72;
  double tolerance = 1e-3;  ///< tolerance of each turn in degrees, see nearest_turn
  /// Whether a path must be free of collisions at all angles between two turns, too; see `reach`.
  bool certain = false;
};

/// A configuration on a path.
struct Waypoint {
  Point at;   ///< position of the reference point
  Turn turn;  ///< the robot's turn
};

/// Tells whether there is a path, and which one.
struct Reach {
  bool reachable = false;  ///< whether there is a path
  /// The path from start to goal, if there is one. From one waypoint to the next the robot moves
  /// straight without turning, or turns on the spot to the neighbouring slice, the shorter way
  /// round.
  std::vector<Waypoint> path;
  std::size_t slices = 0;  ///< number of slices that were made
  std::size_t parts = 0;   ///< number of free parts in all slices
  /// By how much the robot was grown in every direction, at least; 0 unless `certain` is set.
  Rational margin;
};

/// Tells whether `to` can be reached from `from` in the sliced free space, and returns a path.
///
/// There is a slice for each of setting.angles turns, one for the turn of `from`, and one for that
/// of `to`. A free part is a polygon of the free space of a slice. The free parts are the nodes of
/// a graph. Two free parts of neighbouring slices are joined if their interiors have a point in
/// common: there the robot can turn by one step.
///
/// The answer is exact for this graph. The path is the shortest that the search (Dijkstra 1959)
/// finds, which need not be the shortest of all. The length of a turn is that of the arc at the
/// robot's radius. Exact arithmetic finds each move to lie in the closed free part, so the robot
/// may touch obstacles. Ways without play do not count: gaps of exactly the robot's width, and
/// points where two free parts touch. A goal that equals the start is always reached.
///
/// Between two slices nothing is known, unless `certain` is set. Then slices are those of the robot
/// grown by ρ = r·tan δ. Here r is the robot's radius. δ is half the largest step, or an end turn's
/// `off` if that is more. Proof: at any angle, the nearer of the two neighbouring turns is at most
/// δ away. A turn by δ about the reference point moves each point of the robot by at most
/// 2r·sin(δ/2) ≤ r·tan δ. So the turned robot lies in the neighbour's robot ⊕ disc(ρ). The octagon
/// with the corners (±ρ, ±5ρ/12) and (±5ρ/12, ±ρ) contains the disc and takes its place. "No" then
/// means that there is no path for the grown robot.
///
/// The time is that of all slices, which options.threads threads make, and of the search. Throws
/// Error: kBadInput as ConfigurationSpace does; with culprit operand 3 if the robot is not free at
/// `from`, and 4 at `to`; if `certain` is set with steps of half a turn or more; otherwise as
/// minkowski_sum does.
[[nodiscard]] MINKSUM_API Reach reach(const Geometry& robot, const Geometry& obstacles,
                                      const Configuration& from, const Configuration& to,
                                      const ReachOptions& setting = {},
                                      const Options& options = {});

}  // namespace minksum

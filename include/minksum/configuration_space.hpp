// Declares the configuration space: where a robot that moves and turns among obstacles can be.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "minksum/export.h"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/transform.hpp"

namespace minksum {

/// A rotation by a rational point of the unit circle, near an angle that was asked for. It consists
/// of quarter turns and a rest of 0 to 90 degrees, whose half has a rational tangent. It maps
/// exactly.
struct MINKSUM_API Turn {
  Rational asked;         ///< the angle asked for, in degrees, counter-clockwise
  int quarters = 0;       ///< quarter turns, 0 to 3
  Rational tan_half;      ///< tangent of half the rest, from 0 to below 1
  double degrees = 0;     ///< the angle of the turn, near `asked`
  double off = 0;         ///< bound on the distance from `asked` in degrees; 0 for quarter turns

  /// Tells whether both are the same rotation, whatever was asked for.
  [[nodiscard]] bool same_as(const Turn& other) const {
    return quarters == other.quarters && tan_half == other.tan_half;
  }
  /// Returns the turn as an exact map about the origin.
  [[nodiscard]] Affine map() const;
  /// Returns the point (cos, sin) of the unit circle.
  [[nodiscard]] Point direction() const;
};

/// Returns the turn within `tolerance` degrees of `degrees` that has the smallest q in tan_half =
/// p/q. Then p² + q², the denominator of turned coordinates, is small. Multiples of 90 degrees are
/// exact. Throws Error(kBadInput) for a tolerance that is not in [1e-10, 1], and for more than 1e6
/// degrees.
[[nodiscard]] MINKSUM_API Turn nearest_turn(const Rational& degrees, double tolerance = 1e-3);
/// Returns n turns, near 0, 360/n, 2·360/n, ... degrees. Throws Error: kBadInput if n is 0 and as
/// `nearest_turn` does; kLimitExceeded for n above a million.
[[nodiscard]] MINKSUM_API std::vector<Turn> full_turn(std::size_t n, double tolerance = 1e-3);

/// What a configuration space depends on besides robot and obstacles.
struct ConfigurationOptions {
  Point reference = {};  ///< the robot's point that says where it is, and about which it turns
  /// The area that the robot must not leave. Without it the plane around the obstacles is free.
  std::optional<Geometry> workspace = {};
};

/// The configurations (x, y, turn) of one turn.
struct Slice {
  Turn turn;  ///< the robot's turn
  /// The closure of all (x, y) at which the robot's interior meets an obstacle or leaves the
  /// workspace. Outside of it the robot is free, and on its boundary the robot touches.
  Geometry obstacles;
  /// The part of the box `ConfigurationSpace::boundary()` outside `obstacles`. It has tight places
  /// if `Options::tight` is set. It is empty unless free space was asked for.
  Geometry free;
  double seconds = 0;  ///< the time to make it, in seconds
};

/// The configuration space of a robot among obstacles, slice by slice.
///
/// At the configuration (x, y, θ) the robot is turned by θ about its reference point, which is at
/// (x, y). In the slice of θ the configuration-space obstacle is O ⊕ −R(θ) (Lozano-Pérez 1983),
/// with R turned and its reference point at the origin. The obstacles' thin parts count, so walls
/// may be polylines. Only the robot's area counts. If a workspace is given, its complement in a
/// frame that no placed robot leaves is one more obstacle.
///
/// All that does not depend on the turn is done once. A slice is exact for its turn. It costs a sum
/// of prepared regions of fixed-width integers, as coordinates turned by a rational rotation have a
/// common denominator. Copies share one state, and any number of threads may use it.
class MINKSUM_API ConfigurationSpace {
 public:
  /// Prepares robot, obstacles and workspace, which are read by `options.fill`. `options` hold for
  /// the slices, too. If `options.tight` is true, free space keeps the places where the robot has
  /// no play, as points and polylines.
  ///
  /// Throws Error(kBadInput): with culprit operand 0 for a robot without area; 1 for obstacles with
  /// thin parts if `options.tight` is true; 2 for a workspace without area. By kStrict each of them
  /// must be valid, or it is the culprit. Otherwise throws as minkowski_sum does.
  ConfigurationSpace(const Geometry& robot, const Geometry& obstacles,
                     const ConfigurationOptions& setting = {}, const Options& options = {});

  /// Copies share the state, and so does an object with what was moved from it.
  ConfigurationSpace(const ConfigurationSpace&) = default;
  ConfigurationSpace& operator=(const ConfigurationSpace&) = default;
  ~ConfigurationSpace() = default;

  /// Returns the box of (x, y) to which free space is confined. With a workspace, it is the
  /// workspace's box, larger by the robot's radius. Otherwise it is the obstacles' box, larger by
  /// twice the radius, so that the robot can go all around. All obstacles of such slices are
  /// strictly inside.
  [[nodiscard]] const Box& boundary() const { return boundary_; }
  /// Enlarges the boundary so that the robot can go around `point`. The boundary of a workspace
  /// stays as it is.
  void include(const Point& point);
  /// Returns an upper bound on the distance of the robot's points from its reference point.
  [[nodiscard]] const Rational& radius() const;
  /// Returns the robot's area, with its reference point at the origin.
  [[nodiscard]] const Region& robot() const;
  /// Returns the same space for the robot ⊕ `by`. It has a boundary of its own: points for which
  /// this boundary was enlarged have to be included again. Throws as minkowski_sum does.
  [[nodiscard]] ConfigurationSpace grown(const Region& by) const;
  /// Tells whether the interior of a region, which is read by kAutomatic, meets an obstacle, other
  /// than the outside of a workspace.
  [[nodiscard]] bool overlaps_obstacle(const Region& region) const;

  /// Returns the slice of one turn, with its free space if `with_free` is set. Complexity and
  /// errors are those of minkowski_sum and `subtract`.
  [[nodiscard]] Slice slice(const Turn& turn, bool with_free = false) const;
  /// Returns the same with memory that is reused.
  [[nodiscard]] Slice slice(const Turn& turn, bool with_free, Workspace& workspace) const;

  /// Makes the slices of all turns on options.threads threads. `finish` is called for each slice by
  /// the thread that made it, in any order. `visit` is called afterwards by this thread, in the
  /// order of the turns. Only a few slices are kept at a time. The first exception of any of these
  /// is passed on after all threads have stopped.
  void for_each_slice(std::span<const Turn> turns, bool with_free,
                      const std::function<void(std::size_t, Slice&)>& finish,
                      const std::function<void(std::size_t, Slice&)>& visit) const;
  /// Returns the slices of all turns, in their order, as `for_each_slice` makes them. All are kept.
  [[nodiscard]] std::vector<Slice> slices(std::span<const Turn> turns,
                                          bool with_free = false) const;

  struct State;

 private:
  void set_up(State state);

  std::shared_ptr<const State> state_;
  Box boundary_;
};

}  // namespace minksum

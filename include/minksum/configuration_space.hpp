// Configuration space: where a robot that moves and turns among obstacles can be.
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

/// A turn by a rational point of the unit circle, near an angle that was asked for: quarter turns,
/// then a rest of 0 to 90 degrees, whose half has a rational tangent. Exact as a map.
struct MINKSUM_API Turn {
  Rational asked;         ///< degrees, counter-clockwise
  int quarters = 0;       ///< 0 to 3
  Rational tan_half;      ///< of the rest: 0 to 1, which excluded
  double degrees = 0;     ///< by how much it turns, near `asked`
  double off = 0;         ///< no more degrees than this from `asked`; 0 for quarter turns

  /// Whether both turn alike, whatever was asked for.
  [[nodiscard]] bool same_as(const Turn& other) const {
    return quarters == other.quarters && tan_half == other.tan_half;
  }
  /// The turn as an exact map, about the origin.
  [[nodiscard]] Affine map() const;
  /// The point (cos, sin) of the unit circle.
  [[nodiscard]] Point direction() const;
};

/// Of all turns by `degrees` within `tolerance` degrees that with the smallest q in tan_half = p/q,
/// so that p² + q², the denominator of turned coordinates, is small. Multiples of 90 degrees are
/// exact. Throws Error(kBadInput) for a tolerance that is not in [1e-10, 1], and for more
/// than 1e6 degrees.
[[nodiscard]] MINKSUM_API Turn nearest_turn(const Rational& degrees, double tolerance = 1e-3);
/// 0, 360/n, 2·360/n, ... (n of them). Throws Error: kBadInput if n is 0,
/// kLimitExceeded for more than a million.
[[nodiscard]] MINKSUM_API std::vector<Turn> full_turn(std::size_t n, double tolerance = 1e-3);

/// What a configuration space is made for, beside robot and obstacles.
struct ConfigurationOptions {
  Point reference = {};  ///< the robot's point that says where it is, and that it turns about
  /// The robot has to stay inside it; without it, all around the obstacles is free.
  std::optional<Geometry> workspace = {};
};

/// The configurations (x, y, turn) of one turn.
struct Slice {
  Turn turn;  ///< of the robot
  /// Closure of the (x, y) at which the robot's interior meets an obstacle, or leaves the
  /// workspace. Outside of it, and on its boundary, the robot is free, or touches.
  Geometry obstacles;
  Geometry free;  ///< the boundary (below) less the obstacles; filled if asked for
  double seconds = 0;  ///< that it took
};

/// The configuration space of a robot among obstacles, slice by slice.
///
/// At the configuration (x, y, θ) the robot is turned by θ about its reference point, which is at
/// (x, y) then. In a slice of one θ the configuration-space obstacle is O ⊕ −R(θ) (Lozano-Pérez
/// 1983), with R turned and its reference point at the origin. What has no area of the obstacles
/// stays: walls may be polylines. Of the robot, only its area counts. Where a workspace is given,
/// its complement in a frame that no placed robot leaves is one more obstacle.
///
/// All that does not depend on the turn is done once. A slice is exact for its turn, and costs a
/// sum of prepared regions of fixed-width integers, as coordinates turned by a rational rotation
/// have a common denominator. Copies share one state; any number of threads may use it.
class MINKSUM_API ConfigurationSpace {
 public:
  /// `options` hold for the slices, too. If `options.tight` is true, free space keeps the places
  /// where the robot has no play, as points and polylines.
  /// Throws Error(kBadInput): culprit operand 0 for a robot without area, 1 for obstacles that the
  /// fill rule refuses, or with thin parts if options.tight is true, 2 for a workspace without
  /// area; and as minkowski_sum does.
  ConfigurationSpace(const Geometry& robot, const Geometry& obstacles,
                     const ConfigurationOptions& setting = {}, const Options& options = {});

  /// The box of (x, y) to which free space is confined: that of the workspace; else of the
  /// obstacles, larger by twice the robot's radius and a little, so that it can go all around them.
  /// All obstacles of slices without a workspace are strictly inside.
  [[nodiscard]] const Box& boundary() const { return boundary_; }
  /// Enlarges the boundary, if it is not that of a workspace, so that the robot can go
  /// around `point`.
  void include(const Point& point);
  /// The robot's largest distance from its reference point is no larger.
  [[nodiscard]] const Rational& radius() const;
  /// The robot's area, its reference point at the origin.
  [[nodiscard]] const Region& robot() const;
  /// The same space for the robot ⊕ `by`, with a boundary of its own: points that this one's was
  /// enlarged for have to be included again. Throws as minkowski_sum does.
  [[nodiscard]] ConfigurationSpace grown(const Region& by) const;
  /// Whether the region's interior meets an obstacle (the outside of a workspace apart).
  [[nodiscard]] bool overlaps_obstacle(const Region& region) const;

  /// The slice of one turn, with its free space if that is asked for.
  [[nodiscard]] Slice slice(const Turn& turn, bool with_free = false) const;
  /// The same with memory that is reused.
  [[nodiscard]] Slice slice(const Turn& turn, bool with_free, Workspace& workspace) const;

  /// Slices of all turns on options.threads threads. `finish` is called for each by the thread that
  /// made it, in any order; then `visit` by this thread, in the order of the turns. Only a few
  /// slices at a time are kept. The first exception of any of these is thrown on, after all
  /// threads have stopped.
  void for_each_slice(std::span<const Turn> turns, bool with_free,
                      const std::function<void(std::size_t, Slice&)>& finish,
                      const std::function<void(std::size_t, Slice&)>& visit) const;
  /// The slices of all turns, in their order, as `for_each_slice` makes them. All are kept.
  [[nodiscard]] std::vector<Slice> slices(std::span<const Turn> turns,
                                          bool with_free = false) const;

  struct State;

 private:
  void set_up(State state);

  std::shared_ptr<const State> state_;
  Box boundary_;
};

}  // namespace minksum

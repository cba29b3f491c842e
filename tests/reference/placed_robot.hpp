// Whether a placed robot collides, by the definition: exact, edge by edge. Shares no code with the
// library beyond its value types.
#pragma once

#include <optional>
#include <vector>

#include "minksum/configuration_space.hpp"
#include "reference/open_polygon.hpp"

namespace minksum::reference {

/// The point of the unit circle to which a turn moves (1, 0).
[[nodiscard]] Pt direction_of(const Turn& turn);
/// By `share` of the tangent of half the angle on the shorter way from one direction to another,
/// which must not be opposite.
[[nodiscard]] Pt turned_towards(const Pt& from, const Pt& to, const Number& share);
/// The tangent of half the angle from one direction to another, counter-clockwise; nothing for
/// opposite ones.
[[nodiscard]] std::optional<Number> half_step(const Pt& from, const Pt& to);
/// Those that differ, counter-clockwise from 0 degrees.
[[nodiscard]] std::vector<Turn> counter_clockwise(std::vector<Turn> turns);

enum class Collision { kNone, kObstacle, kWorkspace };

/// A robot, and all that is in its way. Regions must be valid; obstacles may overlap one another in
/// any way.
class PlacedRobot {
 public:
  PlacedRobot(const Region& robot, const Point& reference, const Geometry& obstacles,
              const Region* workspace);

  /// Of the robot turned to `direction` about its reference point, which is at `at` then.
  [[nodiscard]] Collision at(const Pt& at, const Pt& direction) const;
  /// Returns whether the robot collides nowhere on a straight way.
  [[nodiscard]] bool is_free_along(const Pt& a, const Pt& b, const Pt& direction) const;

 private:
  /// A polygon of the robot, its reference point at the origin.
  struct Body {
    Loops loops;
    Pt inner;
  };
  [[nodiscard]] std::vector<OpenPolygon> placed(const Pt& at, const Pt& direction) const;
  [[nodiscard]] bool leaves_workspace(const OpenPolygon& body) const;

  std::vector<Body> bodies_;
  std::vector<OpenPolygon> obstacles_;
  std::vector<OpenPolygon> workspace_;
  bool has_workspace_;
  std::vector<Span> walls_;  ///< and single points
};

}  // namespace minksum::reference

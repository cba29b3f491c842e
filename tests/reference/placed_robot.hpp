// Tells exactly whether a placed robot collides, by the definition and edge by edge. Shares no code
// with the library beyond its value types.
#pragma once

#include <optional>
#include <vector>

#include "minksum/configuration_space.hpp"
#include "reference/open_polygon.hpp"

namespace minksum::reference {

/// Returns the point of the unit circle to which a turn moves (1, 0).
[[nodiscard]] Pt direction_of(const Turn& turn);
/// Returns `from` turned the shorter way towards `to`, by `share` of the tangent of half the angle.
/// The two directions must not be opposite.
[[nodiscard]] Pt turned_towards(const Pt& from, const Pt& to, const Number& share);
/// Returns the tangent of half the counter-clockwise angle from one direction to another; nothing
/// for opposite ones.
[[nodiscard]] std::optional<Number> half_step(const Pt& from, const Pt& to);
/// Returns the turns without duplicates, counter-clockwise from 0 degrees.
[[nodiscard]] std::vector<Turn> counter_clockwise(std::vector<Turn> turns);

enum class Collision { kNone, kObstacle, kWorkspace };

/// A robot and all that is in its way. Regions must be valid; obstacles may overlap one another in
/// any way.
class PlacedRobot {
 public:
  PlacedRobot(const Region& robot, const Point& reference, const Geometry& obstacles,
              const Region* workspace);

  /// Returns how the robot collides after it was turned to `direction` about its reference point,
  /// which is then moved to `at`.
  [[nodiscard]] Collision at(const Pt& at, const Pt& direction) const;
  /// Returns whether the robot collides nowhere on a straight way.
  [[nodiscard]] bool is_free_along(const Pt& a, const Pt& b, const Pt& direction) const;

 private:
  /// A polygon of the robot, moved so that its reference point is the origin.
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
  std::vector<Span> walls_;  ///< walls and single points
};

}  // namespace minksum::reference

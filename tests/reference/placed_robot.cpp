#include "reference/placed_robot.hpp"

#include <algorithm>
#include <utility>

#include "reference/canonical.hpp"
#include "reference/membership.hpp"

namespace minksum::reference {
namespace {

/// Returns `p` turned by the angle from (1, 0) to `direction`.
Pt turned(const Pt& p, const Pt& direction) {
  return {Number(p.x * direction.x - p.y * direction.y),
          Number(p.x * direction.y + p.y * direction.x)};
}
Pt plus(const Pt& a, const Pt& b) { return {Number(a.x + b.x), Number(a.y + b.y)}; }

/// Returns the direction at twice the angle with this tangent.
Pt direction_of_half(const Number& tangent) {
  const Number square = tangent * tangent;
  return {Number((1 - square) / (1 + square)), Number(2 * tangent / (1 + square))};
}

/// Returns the polygons with connected insides, as the canonical form has them.
std::vector<OpenPolygon> open_polygons(const Region& region) {
  std::vector<OpenPolygon> polygons;
  for (const Loops& loops : to_loops(canonical(region))) polygons.emplace_back(loops);
  return polygons;
}

/// Orders turns counter-clockwise from 0 degrees.
bool comes_before(const Turn& a, const Turn& b) {
  const Pt p = direction_of(a);
  const Pt q = direction_of(b);
  const auto is_upper = [](const Pt& d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
  if (is_upper(p) != is_upper(q)) return is_upper(p);
  return p.x * q.y > p.y * q.x;
}

}  // namespace

Pt direction_of(const Turn& turn) {
  Pt direction = direction_of_half(to_number(turn.tan_half));
  for (int i = 0; i < turn.quarters; ++i) direction = {Number(-direction.y), direction.x};
  return direction;
}

std::optional<Number> half_step(const Pt& from, const Pt& to) {
  const Number cosine = from.x * to.x + from.y * to.y;
  if (cosine == -1) return std::nullopt;
  return Number((from.x * to.y - from.y * to.x) / (1 + cosine));
}

Pt turned_towards(const Pt& from, const Pt& to, const Number& share) {
  return turned(from, direction_of_half(half_step(from, to).value() * share));
}

std::vector<Turn> counter_clockwise(std::vector<Turn> turns) {
  std::sort(turns.begin(), turns.end(), comes_before);
  const auto same = [](const Turn& a, const Turn& b) { return direction_of(a) == direction_of(b); };
  turns.erase(std::unique(turns.begin(), turns.end(), same), turns.end());
  return turns;
}

PlacedRobot::PlacedRobot(const Region& robot, const Point& reference, const Geometry& obstacles,
                         const Region* workspace)
    : obstacles_(open_polygons(obstacles.region)), has_workspace_(workspace != nullptr) {
  if (workspace != nullptr) workspace_ = open_polygons(*workspace);
  const Pt home = to_pt(reference);
  for (Loops& loops : to_loops(canonical(robot))) {
    for (Loop& loop : loops) {
      for (Pt& p : loop) p = minus(p, home);
    }
    Pt inner = point_strictly_inside(loops);
    bodies_.push_back({std::move(loops), std::move(inner)});
  }
  for (const Polyline& line : obstacles.polylines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      walls_.push_back({Spot(to_pt(line[i])), Spot(to_pt(line[i + 1]))});
    }
  }
  for (const Point& p : obstacles.points) walls_.push_back({Spot(to_pt(p)), Spot(to_pt(p))});
}

std::vector<OpenPolygon> PlacedRobot::placed(const Pt& at, const Pt& direction) const {
  std::vector<OpenPolygon> result;
  for (const Body& body : bodies_) {
    Loops loops = body.loops;
    for (Loop& loop : loops) {
      for (Pt& p : loop) p = plus(turned(p, direction), at);
    }
    result.emplace_back(loops, plus(turned(body.inner, direction), at));
  }
  return result;
}

bool PlacedRobot::leaves_workspace(const OpenPolygon& body) const {
  // The body is connected, so it leaves across an edge or lies outside altogether.
  bool is_elsewhere = true;
  for (const OpenPolygon& room : workspace_) {
    for (const Span& edge : room.edges()) {
      if (body.is_entered_by(edge)) return true;
    }
    if (room.locate(body.inner()) == Side::kInside) is_elsewhere = false;
  }
  return is_elsewhere;
}

Collision PlacedRobot::at(const Pt& at, const Pt& direction) const {
  Collision found = Collision::kNone;
  for (const OpenPolygon& body : placed(at, direction)) {
    if (has_workspace_ && leaves_workspace(body)) return Collision::kWorkspace;
    const auto meets = [&](const OpenPolygon& obstacle) { return insides_meet(body, obstacle); };
    const auto enters = [&](const Span& wall) { return body.is_entered_by(wall); };
    if (std::any_of(obstacles_.begin(), obstacles_.end(), meets) ||
        std::any_of(walls_.begin(), walls_.end(), enters)) {
      found = Collision::kObstacle;
    }
  }
  return found;
}

bool PlacedRobot::is_free_along(const Pt& a, const Pt& b, const Pt& direction) const {
  // Collisions change only where a vertex of the robot reaches or leaves an edge, or an edge of the
  // robot reaches a vertex.
  const Pt way = minus(b, a);
  std::vector<Span> still = walls_;
  for (const auto* polygons : {&obstacles_, &workspace_}) {
    for (const OpenPolygon& polygon : *polygons) {
      still.insert(still.end(), polygon.edges().begin(), polygon.edges().end());
    }
  }
  std::vector<Number> meetings;
  for (const OpenPolygon& body : placed(a, direction)) {
    for (const Span& edge : body.edges()) {
      add_meetings({edge.a, Spot(plus(edge.a.at, way))}, still, meetings);
    }
    for (const Span& edge : still) {
      for (const Spot* end : {&edge.a, &edge.b}) {
        add_meetings({*end, Spot(minus(end->at, way))}, body.edges(), meetings);
      }
    }
  }
  const Span path{Spot(a), Spot(b)};
  const std::vector<Number> gaps = between_meetings(std::move(meetings));
  return std::all_of(gaps.begin(), gaps.end(), [&](const Number& t) {
    return at(path.along(t), direction) == Collision::kNone;
  });
}

}  // namespace minksum::reference

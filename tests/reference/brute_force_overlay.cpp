#include "reference/brute_force_overlay.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "reference/canonical.hpp"
#include "reference/exact.hpp"
#include "reference/validity.hpp"

namespace minksum::reference {
namespace {

/// A directed edge of a ring. The winding numbers of rings of one `group` add up; polylines have
/// the group kThin.
struct GroupedEdge {
  Pt a;
  Pt b;
  int group = 0;
};
constexpr int kThin = -1;

/// Winding numbers of a point by group.
using Windings = std::map<int, int>;
using Keep = std::function<bool(Windings&)>;

/// A piece of an edge, or a point, with no area beside it.
struct Wall {
  std::set<int> on;              ///< the groups whose edges hold it
  std::vector<Windings> around;  ///< on both sides of a piece, or all around a point
  bool is_point = false;
};
using KeepWall = std::function<bool(Wall&)>;

bool is_on_any(Wall& wall) { return !wall.on.empty(); }
bool is_on_polyline(Wall& wall) { return wall.on.contains(kThin); }

struct Input {
  std::vector<GroupedEdge> edges;
  std::vector<GroupedEdge> points;  ///< points, and edges that collapse to a point

  void add_ring(Loop loop, int group, int orientation) {
    if (loop.empty()) return;
    const Number area = doubled_area(loop);
    if ((orientation > 0 && area < 0) || (orientation < 0 && area > 0)) {
      std::reverse(loop.begin(), loop.end());
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges.push_back({loop[i], loop[(i + 1) % loop.size()], group});
    }
    if (std::count(loop.begin(), loop.end(), loop[0]) == static_cast<std::ptrdiff_t>(loop.size())) {
      points.push_back({loop[0], loop[0], group});
    }
  }
  /// Adds rings. With `by_role`, outer rings run counter-clockwise and holes clockwise.
  void add_region(const Region& region, int group, bool by_role) {
    for (const Loops& loops : to_loops(region)) {
      for (std::size_t r = 0; r < loops.size(); ++r) {
        add_ring(loops[r], group, !by_role ? 0 : r == 0 ? 1 : -1);
      }
    }
  }
  void add_thin(const Geometry& geometry) {
    for (const Polyline& line : geometry.polylines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        edges.push_back({to_pt(line[i]), to_pt(line[i + 1]), kThin});
      }
      if (!line.empty()) add_point(line[0]);
    }
    for (const Point& point : geometry.points) add_point(point);
  }
  void add_point(const Point& point) { points.push_back({to_pt(point), to_pt(point), kThin}); }
};

Pt meeting_point(const GroupedEdge& e, const GroupedEdge& f) {
  const Number ex = e.b.x - e.a.x;
  const Number ey = e.b.y - e.a.y;
  const Number fx = f.b.x - f.a.x;
  const Number fy = f.b.y - f.a.y;
  const Number t = ((f.a.x - e.a.x) * fy - (f.a.y - e.a.y) * fx) / (ex * fy - ey * fx);
  return {e.a.x + t * ex, e.a.y + t * ey};
}

/// Returns whether the ray from `from` through `towards` meets the edge. Sets the distance, where 1
/// means at `towards`.
bool hit(const Pt& from, const Pt& towards, const GroupedEdge& edge, Number& distance) {
  const Number dx = towards.x - from.x;
  const Number dy = towards.y - from.y;
  const auto side = [&](const Pt& p) { return dx * (p.y - from.y) - dy * (p.x - from.x); };
  const auto along = [&](const Pt& p) {
    return Number((dx * (p.x - from.x) + dy * (p.y - from.y)) / (dx * dx + dy * dy));
  };
  const Number a = side(edge.a);
  const Number b = side(edge.b);
  if ((a < 0 && b < 0) || (a > 0 && b > 0)) return false;
  if (a == b) {
    const Number s = along(edge.a);
    const Number t = along(edge.b);
    distance = s <= 0 || t <= 0 ? std::max(s, t) : std::min(s, t);
    return distance > 0;
  }
  const Number part = a / (a - b);
  distance =
      along({edge.a.x + part * (edge.b.x - edge.a.x), edge.a.y + part * (edge.b.y - edge.a.y)});
  return distance > 0;
}

Windings windings_at(const Pt& p, const std::vector<GroupedEdge>& edges) {
  Windings result;
  for (const GroupedEdge& e : edges) {
    if (e.group == kThin) continue;
    const bool up = e.a.y <= p.y;
    if (up == (e.b.y <= p.y)) continue;  // an edge owns its lower end only
    const int side = turn(e.a, e.b, p);
    if (up && side > 0) ++result[e.group];
    if (!up && side < 0) --result[e.group];
  }
  return result;
}

class Overlay {
 public:
  Overlay(const Input& input, Keep keep, KeepWall keep_wall)
      : input_(input), keep_(std::move(keep)), keep_wall_(std::move(keep_wall)) {}

  Geometry run() {
    cut();
    std::vector<Piece> boundary;
    std::vector<std::pair<std::size_t, std::size_t>> thin;
    std::set<std::size_t> on_area;
    for (const auto& [from, to] : pieces_) {
      Wall wall{groups_at(midpoint(nodes_[from], nodes_[to])),
                {beside(from, to), beside(to, from)},
                false};
      const bool left = keep_(wall.around[0]);
      const bool right = keep_(wall.around[1]);
      if (left || right) on_area.insert({from, to});
      if (left && !right) boundary.push_back({from, to});
      if (right && !left) boundary.push_back({to, from});
      if (!left && !right && keep_wall_(wall)) thin.emplace_back(from, to);
    }
    Geometry result;
    result.region = link(nodes_, boundary);
    add_polylines(thin, on_area, result);
    add_points(thin, result);
    return result;
  }

 private:
  std::size_t id_of(const Pt& p) {
    const auto [it, is_new] = ids_.try_emplace(p, nodes_.size());
    if (is_new) nodes_.push_back(p);
    return it->second;
  }

  void cut() {
    for (const GroupedEdge& e : input_.edges) {
      std::set<Pt> stops{e.a, e.b};
      for (const GroupedEdge& f : input_.edges) {
        if (on_segment(f.a, e.a, e.b)) stops.insert(f.a);
        if (on_segment(f.b, e.a, e.b)) stops.insert(f.b);
        if (cross_properly(e.a, e.b, f.a, f.b)) stops.insert(meeting_point(e, f));
      }
      std::size_t previous = 0;
      bool first = true;
      for (const Pt& stop : stops) {  // the set's order is that along the edge
        const std::size_t id = id_of(stop);
        if (!first) pieces_.insert({std::min(previous, id), std::max(previous, id)});
        previous = id;
        first = false;
      }
    }
  }

  /// Returns the winding numbers of the face on the left of a piece.
  Windings beside(std::size_t from, std::size_t to) {
    const Pt middle = midpoint(nodes_[from], nodes_[to]);
    const Pt aim{middle.x - (nodes_[to].y - nodes_[from].y),
                 middle.y + (nodes_[to].x - nodes_[from].x)};
    Number nearest = 1;
    for (const GroupedEdge& e : input_.edges) {
      Number distance;
      if (hit(middle, aim, e, distance)) nearest = std::min(nearest, distance);
    }
    const Number half = nearest / 2;
    const Pt sample{middle.x + half * (aim.x - middle.x), middle.y + half * (aim.y - middle.y)};
    return windings_at(sample, input_.edges);
  }

  std::set<int> groups_at(const Pt& p) const {
    std::set<int> groups;
    for (const GroupedEdge& e : input_.edges) {
      if (on_segment(p, e.a, e.b)) groups.insert(e.group);
    }
    return groups;
  }
  std::vector<Windings> faces_around(const Pt& p) {
    std::vector<Windings> faces;
    const auto node = ids_.find(p);
    for (const auto& [from, to] : pieces_) {
      if (node == ids_.end() || (from != node->second && to != node->second)) continue;
      faces.push_back(beside(from, to));
      faces.push_back(beside(to, from));
    }
    if (faces.empty()) faces.push_back(windings_at(p, input_.edges));
    return faces;
  }

  /// Joins paths two by two as long as that is allowed.
  void add_polylines(const std::vector<std::pair<std::size_t, std::size_t>>& thin,
                     const std::set<std::size_t>& on_area, Geometry& result) {
    std::map<std::size_t, int> degree;
    std::vector<std::vector<std::size_t>> paths;
    for (const auto& [from, to] : thin) {
      ++degree[from];
      ++degree[to];
      paths.push_back({from, to});
    }
    for (const auto& [node, count] : degree) {
      if (count != 2 || on_area.contains(node)) continue;
      std::vector<std::size_t> joined;
      for (auto path = paths.begin(); path != paths.end();) {
        if (path->front() != node && path->back() != node) {
          ++path;
          continue;
        }
        if (joined.empty()) {
          if (path->front() == node) std::reverse(path->begin(), path->end());
          joined = *path;
        } else {
          if (path->back() == node) std::reverse(path->begin(), path->end());
          joined.insert(joined.end(), path->begin() + 1, path->end());
        }
        path = paths.erase(path);
      }
      paths.push_back(joined);
    }
    std::vector<Loop> lines;
    for (const std::vector<std::size_t>& path : paths) {
      const bool free_loop = path.front() == path.back() && degree[path.front()] == 2 &&
                             !on_area.contains(path.front());
      lines.push_back(canonical_line(path, free_loop));
    }
    std::sort(lines.begin(), lines.end());
    for (const Loop& line : lines) {
      Polyline polyline;
      for (const Pt& p : line) polyline.push_back({to_rational(p.x), to_rational(p.y)});
      result.polylines.push_back(std::move(polyline));
    }
  }
  Loop canonical_line(const std::vector<std::size_t>& path, bool free_loop) const {
    Loop line;
    for (const std::size_t node : path) line.push_back(nodes_[node]);
    if (free_loop) {
      line.pop_back();
      std::rotate(line.begin(), std::min_element(line.begin(), line.end()), line.end());
      line.push_back(line.front());
    }
    Loop corners;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool end = i == 0 || i + 1 == line.size();
      if (end || turn(line[i - 1], line[i], line[i + 1]) != 0) corners.push_back(line[i]);
    }
    Loop reversed(corners.rbegin(), corners.rend());
    return std::min(corners, reversed);
  }

  void add_points(const std::vector<std::pair<std::size_t, std::size_t>>& thin, Geometry& result) {
    std::set<Pt> alone;
    for (const GroupedEdge& point : input_.points) {
      Wall wall{{point.group}, faces_around(point.a), true};
      if (keep_wall_(wall)) alone.insert(point.a);
    }
    for (const Pt& p : alone) {
      const bool on_line = std::any_of(thin.begin(), thin.end(), [&](const auto& piece) {
        return on_segment(p, nodes_[piece.first], nodes_[piece.second]);
      });
      if (on_line || in_area(p, result.region)) continue;
      result.points.push_back({to_rational(p.x), to_rational(p.y)});
    }
  }
  static bool in_area(const Pt& p, const Region& region) {
    bool odd = false;
    for (const Loops& loops : to_loops(region)) {
      for (const Loop& loop : loops) {
        const Side side = locate(p, loop);
        if (side == Side::kBoundary) return true;
        odd ^= side == Side::kInside;
      }
    }
    return odd;
  }

  const Input& input_;
  Keep keep_;
  KeepWall keep_wall_;
  std::map<Pt, std::size_t> ids_;
  std::vector<Pt> nodes_;
  std::set<std::pair<std::size_t, std::size_t>> pieces_;
};

bool filled(FillRule rule, int winding) {
  switch (rule) {
    case FillRule::kEvenOdd:
      return winding % 2 != 0;
    case FillRule::kPositive:
      return winding > 0;
    case FillRule::kNegative:
      return winding < 0;
    default:
      return winding != 0;
  }
}

/// The groups of the rings of one polygon, and what the polygon holds.
struct Rings {
  int outer = 0;
  std::vector<int> holes;

  bool is_in_a_hole(Windings& face) const {
    return std::any_of(holes.begin(), holes.end(), [&](int hole) { return face[hole] != 0; });
  }
  bool holds(Windings& face) const { return face[outer] != 0 && !is_in_a_hole(face); }
  /// Returns whether the polygon holds a piece or point. A hole takes away what it winds around,
  /// except its own ring. It takes away a point if holes are all around that point.
  bool holds(Wall& wall) const {
    if (wall.is_point) {
      return wall.on.contains(outer) &&
             !std::all_of(wall.around.begin(), wall.around.end(),
                          [&](Windings& face) { return is_in_a_hole(face); });
    }
    // A piece that is not on a ring has the same winding number of that ring on both sides.
    Windings& beside = wall.around.front();
    if (!wall.on.contains(outer) && beside[outer] == 0) return false;
    return std::none_of(holes.begin(), holes.end(),
                        [&](int hole) { return !wall.on.contains(hole) && beside[hole] != 0; });
  }
};

/// Resolves by the definition of the automatic rule: polygon by polygon, with a group for each
/// ring.
Geometry brute_force_polygons(const Geometry& geometry, bool regularize) {
  Input input;
  std::vector<Rings> polygons;
  int group = 0;
  for (const Loops& loops : to_loops(geometry.region)) {
    if (loops.empty()) continue;
    Rings& rings = polygons.emplace_back();
    for (std::size_t r = 0; r < loops.size(); ++r) {
      input.add_ring(loops[r], group, 0);
      if (r == 0) rings.outer = group;
      if (r != 0) rings.holes.push_back(group);
      ++group;
    }
  }
  const auto any = [&](auto& place) {
    return std::any_of(polygons.begin(), polygons.end(),
                       [&](const Rings& rings) { return rings.holds(place); });
  };
  if (regularize) {
    input.points.clear();
    return Overlay(input, any, [](Wall&) { return false; }).run();
  }
  input.add_thin(geometry);
  return Overlay(input, any, [&](Wall& wall) { return is_on_polyline(wall) || any(wall); }).run();
}

}  // namespace

Geometry brute_force_resolve(const Geometry& geometry, FillRule rule, bool regularize) {
  if (rule == FillRule::kAutomatic) return brute_force_polygons(geometry, regularize);
  Input input;
  input.add_region(geometry.region, 0, rule == FillRule::kStrict);
  if (!regularize) input.add_thin(geometry);
  if (regularize) input.points.clear();
  const auto keep = [&](Windings& w) { return filled(rule, w[0]); };
  return Overlay(input, keep, [&](Wall& wall) { return !regularize && is_on_any(wall); }).run();
}

Region brute_force_boolean(const Region& a, const Region& b,
                           const std::function<bool(bool, bool)>& keep) {
  Input input;
  input.add_region(a, 0, true);
  input.add_region(b, 1, true);
  input.points.clear();
  const auto in_result = [&](Windings& w) { return keep(w[0] != 0, w[1] != 0); };
  return Overlay(input, in_result, [](Wall&) { return false; }).run().region;
}

Geometry brute_force_unite(std::span<const Geometry> geometries) {
  Input input;
  for (const Geometry& geometry : geometries) {
    input.add_region(geometry.region, 0, true);
    input.add_thin(geometry);
  }
  return Overlay(
             input, [](Windings& w) { return w[0] != 0; }, is_on_any)
      .run();
}

std::string resolved_fault(const Geometry& geometry) {
  const std::string fault = canonical_fault(geometry.region);
  if (!fault.empty()) return fault;
  if (!(brute_force_resolve(geometry, FillRule::kAutomatic) == geometry)) {
    return "polylines or points are not in resolved form";
  }
  return {};
}

}  // namespace minksum::reference

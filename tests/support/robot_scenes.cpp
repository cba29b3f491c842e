#include "support/robot_scenes.hpp"

#include <algorithm>
#include <sstream>

#include "minksum/measure.hpp"
#include "reference/validity.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"

namespace minksum::test {
namespace {

Polygon box_of(const Rational& min_x, const Rational& min_y, const Rational& max_x,
               const Rational& max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

/// Returns how much more room there is than the robot needs, which is mostly none.
Rational random_play(Random& random) {
  switch (random.below(8)) {
    case 0:
      return Rational(1, 1000);
    case 1:
      return Rational(-1, 1000);
    case 2:
      return Rational(Decimal{random.one_in(2) ? 1 : -1, -15});
    case 3:
      return Rational(random.between(1, 8), 2);
    default:
      return 0;
  }
}

/// Adds random polylines, and polylines between vertices of the region, some along its edges.
void add_walls(Random& random, Geometry& obstacles, int size) {
  const Geometry thin = random_thin(random, 6);
  const Geometry walls = scaled(thin, Rational(size, 6));
  obstacles.polylines = walls.polylines;
  obstacles.points = walls.points;
  const Region& region = obstacles.region;
  if (region.empty() || random.one_in(2)) return;
  Polyline path;
  for (int i = random.between(2, 3); i > 0; --i) {
    const Point next = region.point(
        static_cast<std::size_t>(random.below(static_cast<int>(region.vertex_count()))));
    if (path.empty() || !(path.back() == next)) path.push_back(next);
  }
  if (path.size() > 1) obstacles.polylines.push_back(path);
}

void make_loose(Random& random, RobotScene& scene) {
  scene.kind = "loose";
  scene.robot = random_region(random);
  const int size = random.between(1, 4);
  if (!random.one_in(6)) {
    scene.obstacles.region = scaled(random_region(random), Rational(size));
  }
  if (random.one_in(2)) add_walls(random, scene.obstacles, 12 * size);
  if (random.one_in(2)) {
    const Region room = scaled(random_region(random), Rational(random.between(2, 8)));
    scene.setting.workspace = Geometry{room, {}, {}};
  }
}

/// Makes obstacles of the robot's size on a grid. The robot is a square, which looks the same in
/// all turns, and free parts touch at points.
void make_lattice(Random& random, RobotScene& scene) {
  scene.kind = "lattice";
  scene.robot = rectangle(-1, -1, 1, 1);
  scene.obstacles.region = scaled(random_cells(random, 4, 4, random.one_in(4), false), 2);
  if (random.one_in(2)) scene.setting.workspace = Geometry{rectangle(0, 0, 8, 8), {}, {}};
  scene.angles = 4;
  scene.turn = full_turn(4)[static_cast<std::size_t>(random.below(4))];
}

/// Makes a robot that fits, in this turn, into a hole of the obstacles, or has a hole for them.
void make_frame(Random& random, RobotScene& scene) {
  scene.kind = "frame";
  const Pair pair = random_pair(random);
  scene.obstacles.region = transform(pair.p, scene.turn.map());
  scene.robot = reflect(pair.q);
}

/// Returns the walls of a slot along the x-axis, from 0 to `length` and `width` high.
Geometry slot(Random& random, const Rational& length, const Rational& width) {
  Geometry walls;
  if (random.one_in(2)) {
    const Polygon sides[] = {box_of(0, -2, length, 0),
                             box_of(1, width, length + Rational(1), width + Rational(3))};
    walls.region = Region(sides);
  } else {
    walls.polylines = {{{0, 0}, {length, 0}}, {{0, width}, {length, width}}};
  }
  if (random.one_in(3)) walls.polylines.push_back({{length, -1}, {length, width + Rational(1)}});
  if (random.one_in(4)) walls.points.push_back({length * Rational(1, 2), width * Rational(1, 3)});
  return walls;
}

/// Returns a wall with a door that is `width` high, in a room.
Geometry door(const Rational& size, const Rational& width, ConfigurationOptions& options) {
  const Rational low = size * Rational(1, 3);
  const Polygon sides[] = {box_of(size, 0, size + Rational(1), low),
                           box_of(size, low + width, size + Rational(1), size + width)};
  const Polygon room = box_of(0, 0, size * Rational(2) + Rational(1), size + width);
  options.workspace = Geometry{Region(room), {}, {}};
  return {Region(sides), {}, {}};
}

/// Makes a slot, a door, or a corridor as workspace. It is as wide as the robot is high in the
/// scene's turn, and lies along the x-axis or along the robot.
void make_narrow(Random& random, RobotScene& scene) {
  scene.robot = random_region(random);
  const Affine turn = scene.turn.map();
  const bool along_robot = random.one_in(2);
  const Box box = *bounding_box(along_robot ? scene.robot : transform(scene.robot, turn));
  Rational width = box.max.y - box.min.y + random_play(random);
  if (width.sign() <= 0) width = box.max.y - box.min.y;
  const Rational length = (box.max.x - box.min.x) * Rational(random.between(1, 3));
  const Affine map = along_robot ? turn : Affine{};
  ConfigurationOptions& options = scene.setting;
  switch (random.below(4)) {
    case 0:
      scene.kind = "door";
      scene.obstacles = door(width * Rational(2) + length, width, options);
      break;
    case 1:
      scene.kind = "corridor";
      options.workspace = Geometry{Region(box_of(0, 0, length, width)), {}, {}};
      if (random.one_in(2)) add_walls(random, scene.obstacles, 6);
      break;
    default:
      scene.kind = "slot";
      scene.obstacles = slot(random, length, width);
  }
  scene.obstacles = transform(scene.obstacles, map);
  if (options.workspace) options.workspace = transform(*options.workspace, map);
}

/// Makes a workspace of the robot's form, into which it fits in this turn without any play.
void make_cast(Random& random, RobotScene& scene) {
  scene.kind = "cast";
  scene.robot = random_region(random);
  Region room = transform(scene.robot, scene.turn.map());
  if (random.one_in(2)) {
    const Region more = together(room, moved(scene.robot, 3 * random.between(4, 12), 0));
    if (reference::validity_fault(more).empty()) room = more;
  }
  scene.setting.workspace = Geometry{std::move(room), {}, {}};
  if (random.one_in(3)) add_walls(random, scene.obstacles, 12);
}

}  // namespace

RobotScene random_robot_scene(Random& random) {
  RobotScene scene;
  static constexpr int kAngles[] = {3, 4, 5, 6, 8, 8, 12};
  scene.angles = static_cast<std::size_t>(kAngles[random.below(7)]);
  // Coarse turns have short fractions.
  scene.tolerance = random.one_in(4) ? 1e-3 : 1.0;
  const std::vector<Turn> turns = full_turn(scene.angles, scene.tolerance);
  scene.turn = turns[static_cast<std::size_t>(random.below(static_cast<int>(turns.size())))];
  switch (random.below(9)) {
    case 0:
    case 1:
      make_frame(random, scene);
      break;
    case 2:
    case 3:
      make_narrow(random, scene);
      break;
    case 4:
      make_cast(random, scene);
      break;
    case 5:
      make_lattice(random, scene);
      return scene;
    default:
      make_loose(random, scene);
  }
  if (random.one_in(2)) {
    scene.setting.reference = {Rational(random.between(-9, 30), 2), Rational(random.below(9), 3)};
  }
  return scene;
}

std::string to_text(const RobotScene& scene) {
  std::ostringstream out;
  out << scene.kind << ", " << scene.angles << " angles, turn " << scene.turn.quarters << " and "
      << scene.turn.tan_half << ", reference " << scene.setting.reference.x << ' '
      << scene.setting.reference.y << "\nrobot " << to_text(scene.robot) << "\nobstacles "
      << to_text(scene.obstacles);
  if (scene.setting.workspace) out << "\nworkspace " << to_text(*scene.setting.workspace);
  return out.str();
}

namespace {

std::size_t any_of(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.below(static_cast<int>(count)));
}

Point between(const Point& a, const Point& b, const Rational& t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

/// Returns a point on the boundary of a random polygon; small ones are as frequent as large ones.
std::optional<Point> place_on(Random& random, const Region& region) {
  if (region.empty()) return std::nullopt;
  const IndexRange rings = region.rings_of(any_of(random, region.polygon_count()));
  const IndexRange vertices = region.vertices_of(rings.front() + any_of(random, rings.size()));
  const std::size_t v = vertices.front() + any_of(random, vertices.size());
  const std::size_t w = v + 1 < vertices.front() + vertices.size() ? v + 1 : vertices.front();
  return between(region.point(v), region.point(w), Rational(random.below(3), 3));
}

std::optional<Point> place_without_play(Random& random, const Geometry& free) {
  if (!free.points.empty() && (free.polylines.empty() || random.one_in(2))) {
    return free.points[any_of(random, free.points.size())];
  }
  if (free.polylines.empty()) return std::nullopt;
  const Polyline& line = free.polylines[any_of(random, free.polylines.size())];
  const std::size_t i = any_of(random, line.size() - 1);
  return between(line[i], line[i + 1], Rational(random.below(4), 3));
}

/// Returns a place at which a vertex of the robot lies on the line between two vertices of things
/// in its way, neighbours or not.
std::optional<Point> contact(Random& random, const RobotScene& scene, const Turn& turn) {
  std::vector<Point> fixed = scene.obstacles.points;
  for (const Polyline& line : scene.obstacles.polylines) {
    fixed.insert(fixed.end(), line.begin(), line.end());
  }
  for (const Region* region : {&scene.obstacles.region, scene.workspace()}) {
    for (std::size_t v = 0; region != nullptr && v < region->vertex_count(); ++v) {
      fixed.push_back(region->point(v));
    }
  }
  if (fixed.empty()) return std::nullopt;
  const std::size_t i = any_of(random, fixed.size());
  const std::size_t k = random.one_in(2) ? (i + 1) % fixed.size() : any_of(random, fixed.size());
  const Point on = between(fixed[i], fixed[k], Rational(random.below(3), 2));
  const Point vertex = scene.robot.point(any_of(random, scene.robot.vertex_count()));
  const Point& home = scene.setting.reference;
  const Point arm = turn.map()({vertex.x - home.x, vertex.y - home.y});
  return Point{on.x - arm.x, on.y - arm.y};
}

}  // namespace

Point random_place(Random& random, const RobotScene& scene, const Slice& slice, const Box& box) {
  std::optional<Point> place;
  switch (random.below(6)) {
    case 0:
      place = place_on(random, slice.free.region);
      break;
    case 1:
      place = place_on(random, slice.obstacles.region);
      break;
    case 2:
      place = place_without_play(random, slice.free);
      break;
    case 3:
      place = contact(random, scene, slice.turn);
      break;
    default:
      break;
  }
  if (!place) {
    return {box.min.x + (box.max.x - box.min.x) * Rational(random.below(101), 100),
            box.min.y + (box.max.y - box.min.y) * Rational(random.below(101), 100)};
  }
  if (random.one_in(4)) {
    const Rational hair(Decimal{1, -15});
    place->x = place->x + hair * Rational(random.between(-1, 1));
    place->y = place->y + hair * Rational(random.between(-1, 1));
  }
  return *place;
}

}  // namespace minksum::test

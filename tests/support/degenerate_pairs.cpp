#include "support/degenerate_pairs.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/messes.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum::test {
namespace {

Point middle(const Point& a, const Point& b) {
  return {(a.x + b.x) / Rational(2), (a.y + b.y) / Rational(2)};
}

Ring untidy_ring(const Ring& ring, Random& random) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& here = ring[i];
    const Point& next = ring[(i + 1) % ring.size()];
    result.push_back(here);
    switch (random.below(14)) {
      case 0:
        result.push_back(here);
        break;
      case 1:
        result.push_back(middle(here, next));
        break;
      case 2: {  // a spike to somewhere near
        result.push_back({here.x + random.between(-2, 2), here.y + random.between(-2, 2)});
        result.push_back(here);
        break;
      }
      case 3:  // along the edge, back, and along again
        result.insert(result.end(), {next, middle(here, next)});
        break;
      default:
        break;
    }
  }
  return result;
}

void add_ring(const Ring& ring, Region& region) {
  region.begin_ring();
  for (const Point& p : ring) region.add_vertex(p.x, p.y);
}

Ring any_ring(const Region& region, Random& random) {
  const Polygon polygon = region.polygon(
      static_cast<std::size_t>(random.below(static_cast<int>(region.polygon_count()))));
  const int ring = random.below(static_cast<int>(polygon.holes.size()) + 1);
  return ring == 0 ? polygon.outer : polygon.holes[static_cast<std::size_t>(ring - 1)];
}

std::pair<Point, Point> any_edge(const Region& region, Random& random) {
  const Ring ring = any_ring(region, random);
  const auto i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
  return {ring[i], ring[(i + 1) % ring.size()]};
}

/// Returns rings and polylines whose vertices lie on up to three lines.
Geometry on_few_lines(Random& random) {
  std::vector<std::pair<Vertex, Vertex>> lines;
  for (int i = random.between(1, 3); i > 0; --i) {
    lines.push_back({{random.between(0, 4), random.between(0, 4)},
                     {random.between(-1, 1), random.between(0, 2)}});
  }
  const auto pick = [&]() -> Point {
    const auto& [at, step] =
        lines[static_cast<std::size_t>(random.below(static_cast<int>(lines.size())))];
    const int k = random.between(-3, 3);
    return {at.x + k * step.x, at.y + k * step.y};
  };
  Geometry result;
  result.region.begin_polygon();
  for (int rings = random.between(1, 2); rings > 0; --rings) {
    Ring ring;
    for (int i = random.between(2, 6); i > 0; --i) ring.push_back(pick());
    add_ring(ring, result.region);
  }
  if (random.one_in(3)) result.polylines.push_back({pick(), pick(), pick()});
  return result;
}

Region small_part(Random& random) {
  switch (random.below(5)) {
    case 0:
      return rectangle(0, 0, random.between(1, 2), random.between(1, 3));
    case 1:
      return make_polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}});
    case 2:
      return random_triangle(random, 3);
    case 3:
      return random_convex(random, random.between(3, 6), 4);
    default:
      return random_cells(random, random.between(1, 3), random.between(1, 3), random.one_in(2),
                          true);
  }
}

Outline outer_outline(const Region& region, std::int64_t sign) {
  Outline outline;
  for (const std::size_t v : region.vertices_of(0)) {
    outline.push_back({sign * static_cast<std::int64_t>(region.x(v)),
                       sign * static_cast<std::int64_t>(region.y(v))});
  }
  return outline;
}

/// Returns a part, and a frame with a hole of its form, or with two holes, one of which is wider.
DegeneratePair part_and_frame(Random& random) {
  const Region part = small_part(random);
  std::vector<Outline> holes{outer_outline(part, -1)};
  if (random.one_in(3)) {
    Outline wider;
    for (const Vertex& v : holes[0]) wider.push_back({2 * v.x + 12, 2 * v.y});
    holes.push_back(wider);
  }
  return {untidy(frame(holes, random.between(1, 2)), random), untidy(part, random),
          "frame and part"};
}

/// Returns a box with slots and rooms of whole units, and a part that may just fit into them.
DegeneratePair slots(Random& random) {
  Region box;
  switch (random.below(3)) {
    case 0:
      box = comb(random.between(2, 3), random.between(1, 2), random.between(1, 4));
      break;
    case 1:
      box = spiral(random.between(1, 2));
      break;
    default:
      box = random_cells(random, random.between(3, 4), random.between(3, 4), random.one_in(2),
                         random.one_in(2));
  }
  return {untidy(box, random), untidy(small_part(random), random), "slots"};
}

DegeneratePair with_itself(Random& random) {
  Geometry p;
  switch (random.below(3)) {
    case 0:
      p = untidy(random_polygon(random), random);
      break;
    case 1:
      p = on_few_lines(random);
      break;
    default:
      p = random_thin(random, 4);
  }
  Geometry q = p;
  switch (random.below(3)) {
    case 0:
      q = scaled(p, -1);
      break;
    case 1: {
      const Rational by = random.between(-3, 3);
      q = transformed(p, [&](const Point& at) -> Point { return {at.x + by, at.y}; });
      break;
    }
    default:
      break;
  }
  return {p, q, "with itself"};
}

Geometry any_operand(Random& random) {
  switch (random.below(6)) {
    case 0:
      return random_mess(random);
    case 1:
      return on_few_lines(random);
    case 2:
      return untidy(lace(random), random);
    case 3:
      return untidy(small_part(random), random);
    case 4:
      return untidy(random_region(random), random);
    default:
      return random_thin(random, random.one_in(2) ? 3 : 8);
  }
}

}  // namespace

Region lace(Random& random) {
  const int columns = random.between(1, 3);
  const int rows = random.between(1, 2);
  std::vector<Outline> holes;
  for (int i = 1; i < 2 * columns; i += 2) {
    for (int j = 1; j < 2 * rows; j += 2) {
      if (!random.one_in(5)) holes.push_back({{i - 1, j}, {i, j - 1}, {i + 1, j}, {i, j + 1}});
    }
  }
  return make_polygon({{0, 0}, {2 * columns, 0}, {2 * columns, 2 * rows}, {0, 2 * rows}}, holes);
}

Geometry untidy(const Region& region, Random& random) {
  Geometry result;
  if (random.one_in(4)) return {scrambled(region, random), {}, {}};
  for (const std::size_t i : region.polygons()) {
    const Polygon polygon = region.polygon(i);
    result.region.begin_polygon();
    add_ring(untidy_ring(polygon.outer, random), result.region);
    for (const Ring& hole : polygon.holes) add_ring(untidy_ring(hole, random), result.region);
  }
  if (random.one_in(8)) add_ring(any_ring(region, random), result.region);
  if (random.one_in(8)) {
    result.region.begin_polygon();
    add_ring(any_ring(region, random), result.region);
  }
  if (random.one_in(8)) {
    const auto [a, b] = any_edge(region, random);
    add_ring({a, b}, result.region);
  }
  if (random.one_in(5)) {
    const auto [a, b] = any_edge(region, random);
    result.polylines.push_back({a, b, {b.x + random.between(-2, 2), b.y + random.between(-2, 2)}});
  }
  if (random.one_in(5)) {
    const auto [a, b] = any_edge(region, random);
    result.points.push_back(middle(a, b));
    result.points.push_back({a.x + random.between(-2, 2), a.y});
  }
  return result;
}

DegeneratePair random_degenerate_pair(Random& random) {
  DegeneratePair pair;
  switch (random.below(9)) {
    case 0:
      pair = {random_mess(random), random_mess(random), "messes"};
      break;
    case 1:
      pair = {on_few_lines(random), on_few_lines(random), "few lines"};
      break;
    case 2:
      pair = with_itself(random);
      break;
    case 3:
      pair = part_and_frame(random);
      break;
    case 4:
      pair = slots(random);
      break;
    case 5:
      pair = {untidy(lace(random), random),
              untidy(random.one_in(2) ? lace(random) : small_part(random), random),
              "touching holes"};
      break;
    default:
      pair = {any_operand(random), any_operand(random), "any"};
  }
  if (random.one_in(6)) pair.q = scaled(pair.q, Rational(1, random.between(2, 4)));
  if (random.one_in(3)) pair.q = scaled(pair.q, -1);
  if (random.one_in(2)) std::swap(pair.p, pair.q);
  return pair;
}

}  // namespace minksum::test

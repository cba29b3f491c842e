#include "support/shapes.hpp"

#include <algorithm>
#include <sstream>

namespace minksum::test {

Region make_region(const std::vector<std::vector<Outline>>& polygons) {
  Region region;
  for (const auto& rings : polygons) {
    region.begin_polygon();
    for (const Outline& ring : rings) {
      region.begin_ring();
      for (const Vertex& v : ring) region.add_vertex(v.x, v.y);
    }
  }
  return region;
}

Region make_polygon(const Outline& outer, const std::vector<Outline>& holes) {
  std::vector<Outline> rings{outer};
  rings.insert(rings.end(), holes.begin(), holes.end());
  return make_region({rings});
}

Region rectangle(std::int64_t min_x, std::int64_t min_y, std::int64_t max_x, std::int64_t max_y) {
  return make_polygon({{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}});
}

Region transformed(const Region& region, const std::function<Point(const Point&)>& f) {
  Region result;
  for (const std::size_t polygon : region.polygons()) {
    result.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        const Point p = f(region.point(v));
        result.add_vertex(p.x, p.y);
      }
    }
  }
  return result;
}

Region moved(const Region& region, const Rational& dx, const Rational& dy) {
  return transformed(region, [&](const Point& p) { return Point{p.x + dx, p.y + dy}; });
}

Region scaled(const Region& region, const Rational& factor) {
  return transformed(region, [&](const Point& p) { return Point{p.x * factor, p.y * factor}; });
}

Region turned(const Region& region) {
  return transformed(region, [](const Point& p) { return Point{-p.y, p.x}; });
}

Region mirrored(const Region& region) {
  return transformed(region, [](const Point& p) { return Point{-p.x, p.y}; });
}

namespace {

void append(Region& result, const Region& region) {
  for (const std::size_t polygon : region.polygons()) {
    result.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        result.add_vertex(region.exact_x(v), region.exact_y(v));
      }
    }
  }
}

std::vector<Point> scrambled_ring(const Region& region, std::size_t ring, Random& random) {
  std::vector<Point> points;
  for (const std::size_t v : region.vertices_of(ring)) points.push_back(region.point(v));
  const int start = random.below(static_cast<int>(points.size()));
  std::rotate(points.begin(), points.begin() + start, points.end());
  if (random.one_in(2)) std::reverse(points.begin(), points.end());
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    const Point& b = points[(i + 1) % points.size()];
    for (int repeat = random.one_in(6) ? random.between(1, 2) : 0; repeat >= 0; --repeat) {
      result.push_back(a);
    }
    if (!random.one_in(5)) continue;
    const Rational t(random.between(1, 3), 4);
    result.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
  }
  return result;
}

}  // namespace

Region together(const Region& a, const Region& b) {
  Region result;
  append(result, a);
  append(result, b);
  return result;
}

Region scrambled(const Region& region, Random& random) {
  Region result;
  for (const std::size_t polygon : region.polygons()) {
    result.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result.begin_ring();
      for (const Point& p : scrambled_ring(region, ring, random)) result.add_vertex(p.x, p.y);
    }
  }
  return result;
}

std::string to_text(const Region& region) {
  std::ostringstream out;
  out << "MULTIPOLYGON (";
  for (const std::size_t polygon : region.polygons()) {
    out << (polygon == 0 ? "(" : ", (");
    for (const std::size_t ring : region.rings_of(polygon)) {
      const IndexRange vertices = region.vertices_of(ring);
      out << (ring == region.rings_of(polygon).front() ? "(" : ", (");
      for (const std::size_t v : vertices) {
        out << region.exact_x(v) << ' ' << region.exact_y(v) << ", ";
      }
      if (!vertices.empty()) {
        out << region.exact_x(vertices.front()) << ' ' << region.exact_y(vertices.front());
      }
      out << ')';
    }
    out << ')';
  }
  out << ')';
  return out.str();
}

}  // namespace minksum::test

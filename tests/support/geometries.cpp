#include "support/geometries.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "minksum/boolean.hpp"
#include "reference/exact.hpp"
#include "support/polygon_kinds.hpp"

namespace minksum::test {
namespace {

using reference::Pt;
using reference::to_pt;

// Returns whether a path may go on from its last vertex to `next`. It must not go straight on, and
// must not touch itself except where it closes.
bool may_go_on(const Polyline& path, const Point& next, bool closing) {
  const Pt a = to_pt(path.back());
  const Pt b = to_pt(next);
  if (a == b) return false;
  if (path.size() > 1 && reference::turn(to_pt(path[path.size() - 2]), a, b) == 0) return false;
  if (closing && reference::turn(a, b, to_pt(path[1])) == 0) return false;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Pt c = to_pt(path[i - 1]);
    const Pt d = to_pt(path[i]);
    if (closing && i == 1 ? reference::on_segment(d, a, b) : reference::segments_meet(a, b, c, d)) {
      return false;
    }
  }
  return true;
}

}  // namespace

Polyline make_polyline(const Outline& vertices) {
  Polyline polyline;
  for (const Vertex& v : vertices) polyline.push_back({v.x, v.y});
  return polyline;
}

Geometry make_lines(const std::vector<Outline>& polylines, const Outline& points) {
  Geometry geometry;
  for (const Outline& polyline : polylines) geometry.polylines.push_back(make_polyline(polyline));
  geometry.points = make_polyline(points);
  return geometry;
}

Polyline random_simple_polyline(Random& random, int edges, int size) {
  Polyline path = make_polyline({random_vertex(random, size)});
  for (int attempt = 0; attempt < 20 && static_cast<int>(path.size()) <= edges; ++attempt) {
    const Point next = make_polyline({random_vertex(random, size)})[0];
    if (may_go_on(path, next, false)) path.push_back(next);
  }
  if (path.size() < 2) return make_polyline({{0, 0}, {size, 1}});
  if (path.size() > 2 && random.one_in(3) && may_go_on(path, path[0], true)) {
    path.push_back(path[0]);
  }
  return path;
}

Geometry random_thin(Random& random, int size) {
  Geometry geometry;
  for (int i = random.below(4); i > 0; --i) {
    Outline vertices;
    for (int k = random.between(2, 5); k > 0; --k) vertices.push_back(random_vertex(random, size));
    geometry.polylines.push_back(make_polyline(vertices));
  }
  if (geometry.polylines.empty() || random.one_in(3)) {
    for (int i = random.between(1, 2); i > 0; --i) {
      geometry.points.push_back(make_polyline({random_vertex(random, size)})[0]);
    }
  }
  return geometry;
}

Geometry scaled(const Geometry& geometry, const Rational& factor) {
  Geometry result{scaled(geometry.region, factor), geometry.polylines, geometry.points};
  const auto scale = [&](Point& p) { p = {p.x * factor, p.y * factor}; };
  for (Polyline& polyline : result.polylines) {
    std::for_each(polyline.begin(), polyline.end(), scale);
  }
  std::for_each(result.points.begin(), result.points.end(), scale);
  return result;
}

bool contains(const Geometry& b, const Geometry& a) { return unite(std::array{a, b}) == b; }

std::string to_text(const Geometry& geometry) {
  std::ostringstream out;
  out << to_text(geometry.region);
  const auto write = [&out](const Point& p) { out << p.x << ' ' << p.y; };
  for (const Polyline& polyline : geometry.polylines) {
    out << " LINESTRING (";
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      if (i > 0) out << ", ";
      write(polyline[i]);
    }
    out << ')';
  }
  for (const Point& point : geometry.points) {
    out << " POINT (";
    write(point);
    out << ')';
  }
  return out.str();
}

}  // namespace minksum::test

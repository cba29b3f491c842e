// Visits the points of sets, and makes images of sets and walks along them, point by point.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"

namespace minksum {

/// Calls visit(point) for all points of the thin parts.
template <class Visit>
void for_each_thin_point(const Geometry& geometry, Visit visit) {
  for (const Polyline& line : geometry.polylines) {
    for (const Point& p : line) visit(p);
  }
  for (const Point& p : geometry.points) visit(p);
}

/// Makes a region whose polygons are walks. A walk goes along a polyline from its start to its end
/// and back: it is a ring without area. Polylines must be as in a resolved Geometry: simple, and
/// without straight vertices. A closed polyline is cut at its first vertex.
inline void walk_there_and_back(std::span<const Polyline> polylines, Cancellation& cancellation,
                                Region& walks) {
  walks.clear();
  for (const Polyline& polyline : polylines) {
    walks.begin_polygon();
    walks.begin_ring();
    const auto add = [&](const Point& at) {
      cancellation.check(work_of(at));
      walks.add_vertex(at.x, at.y);
    };
    std::for_each(polyline.begin(), polyline.end(), add);
    std::for_each(polyline.rbegin() + 1, polyline.rend() - 1, add);
  }
}

/// Returns a region with the rings of another one; add(image, v) adds the image of vertex v.
template <class Add>
[[nodiscard]] Region with_same_rings(const Region& region, Add add) {
  Region image;
  for (const std::size_t polygon : region.polygons()) {
    image.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      image.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) add(image, v);
    }
  }
  return image;
}
/// Returns the image of a region under a map of points.
template <class Map>
[[nodiscard]] Region mapped(const Region& region, Map map) {
  return with_same_rings(region, [&](Region& image, std::size_t v) {
    const Point at = map(region.point(v));
    image.add_vertex(at.x, at.y);
  });
}
/// Returns the image of a geometry. `region` is the image of its region; `map` gives those of the
/// other points.
template <class Map>
[[nodiscard]] Geometry mapped(const Geometry& geometry, Region region, Map map) {
  Geometry image{std::move(region), {}, {}};
  for (const Polyline& line : geometry.polylines) {
    Polyline& path = image.polylines.emplace_back();
    for (const Point& at : line) path.push_back(map(at));
  }
  for (const Point& at : geometry.points) image.points.push_back(map(at));
  return image;
}

}  // namespace minksum

// Visits the points of sets, and makes images of sets, point by point.
#pragma once

#include <utility>

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
/// Returns the image of a geometry whose region has the given one.
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

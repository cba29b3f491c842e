#ifdef MINKSUM_TEST_GEOS
#include "support/geos_geometry.hpp"

#include <vector>

namespace minksum::test {
namespace {

GEOSCoordSequence* to_points(GEOSContextHandle_t context, const std::vector<Point>& path) {
  GEOSCoordSequence* const points =
      GEOSCoordSeq_create_r(context, static_cast<unsigned>(path.size()), 2);
  for (unsigned i = 0; i < path.size(); ++i) {
    GEOSCoordSeq_setXY_r(context, points, i, path[i].x.to_double(), path[i].y.to_double());
  }
  return points;
}

GEOSGeometry* to_ring(GEOSContextHandle_t context, Ring ring) {
  ring.push_back(ring.front());
  return GEOSGeom_createLinearRing_r(context, to_points(context, ring));
}

GEOSGeometry* collect(GEOSContextHandle_t context, int type, std::vector<GEOSGeometry*>& parts) {
  return GEOSGeom_createCollection_r(context, type, parts.data(),
                                     static_cast<unsigned>(parts.size()));
}

void add_ring(GEOSContextHandle_t context, const GEOSGeometry* from, Region& region) {
  const GEOSCoordSequence* const points = GEOSGeom_getCoordSeq_r(context, from);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(context, points, &size);
  region.begin_ring();
  for (unsigned i = 0; i + 1 < size; ++i) {
    double x = 0, y = 0;
    GEOSCoordSeq_getXY_r(context, points, i, &x, &y);
    region.add_vertex(x, y);
  }
}

}  // namespace

GeosGeometry to_geos(GEOSContextHandle_t context, const Geometry& geometry) {
  std::vector<GEOSGeometry*> polygons;
  for (const std::size_t index : geometry.region.polygons()) {
    const Polygon polygon = geometry.region.polygon(index);
    GEOSGeometry* const outer = to_ring(context, polygon.outer);
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes) holes.push_back(to_ring(context, hole));
    polygons.push_back(GEOSGeom_createPolygon_r(context, outer, holes.data(),
                                                static_cast<unsigned>(holes.size())));
  }
  GEOSGeometry* const area = collect(context, GEOS_MULTIPOLYGON, polygons);
  if (!geometry.has_thin_parts()) return GeosGeometry(area, {context});
  std::vector<GEOSGeometry*> parts{area};
  for (const Polyline& line : geometry.polylines) {
    parts.push_back(GEOSGeom_createLineString_r(context, to_points(context, line)));
  }
  for (const Point& point : geometry.points) {
    parts.push_back(
        GEOSGeom_createPointFromXY_r(context, point.x.to_double(), point.y.to_double()));
  }
  return GeosGeometry(collect(context, GEOS_GEOMETRYCOLLECTION, parts), {context});
}

Region from_geos(GEOSContextHandle_t context, const GEOSGeometry* geometry) {
  Region region;
  for (int i = 0; i < GEOSGetNumGeometries_r(context, geometry); ++i) {
    const GEOSGeometry* const part = GEOSGetGeometryN_r(context, geometry, i);
    if (GEOSGeomTypeId_r(context, part) != GEOS_POLYGON || GEOSisEmpty_r(context, part) == 1) {
      continue;
    }
    region.begin_polygon();
    add_ring(context, GEOSGetExteriorRing_r(context, part), region);
    for (int k = 0; k < GEOSGetNumInteriorRings_r(context, part); ++k) {
      add_ring(context, GEOSGetInteriorRingN_r(context, part, k), region);
    }
  }
  return region;
}

}  // namespace minksum::test
#endif

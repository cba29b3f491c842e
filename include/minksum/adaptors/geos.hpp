// Converts geometries from and to GEOS by its C interface. This header is optional: it is only for
// programs that have GEOS (LGPL) themselves. The library minksum neither contains GEOS nor links
// it.
#pragma once

#include <geos_c.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "minksum/adaptors/shared.hpp"
#include "minksum/error.hpp"
#include "minksum/geometry.hpp"
#include "minksum/region.hpp"

namespace minksum::adaptors {

/// Destroys a geometry of GEOS in its context, which must live longer.
struct GeosDeleter {
  GEOSContextHandle_t context = nullptr;  ///< the context that made the geometry
  /// Destroys the geometry.
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
};
/// A geometry of GEOS and its owner. `release()` hands it over to GEOS.
using GeosGeometry = std::unique_ptr<GEOSGeometry, GeosDeleter>;

namespace detail {

struct GeosSequenceDeleter {
  GEOSContextHandle_t context;
  void operator()(GEOSCoordSequence* points) const { GEOSCoordSeq_destroy_r(context, points); }
};

struct GeosPoint {
  double x;
  double y;
};

/// Reads geometries of all kinds into one.
class GeosReader {
 public:
  explicit GeosReader(GEOSContextHandle_t context) : context_(context) {}

  void read(const GEOSGeometry* from) {
    if (from == nullptr) reject("a null pointer is no geometry of GEOS");
    const int type = GEOSGeomTypeId_r(context_, from);
    switch (type) {
      case GEOS_POLYGON:
        return read_polygon(from);
      case GEOS_LINESTRING:
      case GEOS_LINEARRING:
        return read_line(from);
      case GEOS_POINT:
        return read_point(from);
      case GEOS_MULTIPOINT:
      case GEOS_MULTILINESTRING:
      case GEOS_MULTIPOLYGON:
      case GEOS_GEOMETRYCOLLECTION:
        return read_parts(from);
      default:
        reject("a geometry of GEOS is of the type " + std::to_string(type) +
               ", which has no exact polygons, lines or points");
    }
  }
  [[nodiscard]] Geometry take() { return std::move(to_); }

 private:
  void read_parts(const GEOSGeometry* from) {
    const int count = GEOSGetNumGeometries_r(context_, from);
    for (int i = 0; i < count; ++i) read(GEOSGetGeometryN_r(context_, from, i));
  }
  void read_polygon(const GEOSGeometry* from) {
    const int holes = GEOSGetNumInteriorRings_r(context_, from);
    const std::vector<GeosPoint> outer = points_of(GEOSGetExteriorRing_r(context_, from));
    bool begun = false;
    if (!outer.empty()) {
      to_.region.begin_polygon();
      begun = true;
      add(outer);
    }
    for (int i = 0; i < holes; ++i) {
      const std::vector<GeosPoint> hole = points_of(GEOSGetInteriorRingN_r(context_, from, i));
      if (hole.empty()) continue;
      if (!begun) reject_holes_alone(to_.region.polygon_count());
      add(hole);
    }
  }
  void add(const std::vector<GeosPoint>& ring) {
    add_ring(
        to_.region, ring.begin(), ring.end(), [](const GeosPoint& point) { return point.x; },
        [](const GeosPoint& point) { return point.y; });
  }
  void read_line(const GEOSGeometry* from) {
    Polyline line;
    for (const GeosPoint& point : points_of(from)) {
      line.push_back(exact(point, "polyline", to_.polylines.size(), line.size()));
    }
    if (!line.empty()) to_.polylines.push_back(std::move(line));
  }
  void read_point(const GEOSGeometry* from) {
    for (const GeosPoint& point : points_of(from)) {
      to_.points.push_back(exact(point, "point", to_.points.size(), Culprit::kNone));
    }
  }
  /// Adds the place to an error, as Rational does not know from where a number comes.
  static Point exact(const GeosPoint& point, const char* kind, std::size_t index,
                     std::size_t vertex) {
    try {
      return {point.x, point.y};
    } catch (const Error& error) {
      Culprit place;
      place.vertex = vertex;
      const std::string where = vertex == Culprit::kNone ? "" : ", " + detail::to_string(place);
      throw Error(error.code(),
                  std::string(error.what()) + ": " + kind + ' ' + std::to_string(index) + where,
                  place);
    }
  }
  [[nodiscard]] std::vector<GeosPoint> points_of(const GEOSGeometry* from) const {
    const GEOSCoordSequence* const sequence =
        from == nullptr ? nullptr : GEOSGeom_getCoordSeq_r(context_, from);
    unsigned size = 0;
    if (sequence == nullptr || GEOSCoordSeq_getSize_r(context_, sequence, &size) == 0) fail();
    std::vector<GeosPoint> points(size);
    for (unsigned i = 0; i < size; ++i) {
      if (GEOSCoordSeq_getXY_r(context_, sequence, i, &points[i].x, &points[i].y) == 0) fail();
    }
    return points;
  }
  [[noreturn]] static void fail() { reject("GEOS does not give the points of a geometry"); }

  GEOSContextHandle_t context_;
  Geometry to_;
};

/// Makes geometries, and destroys them if an error follows.
class GeosWriter {
 public:
  explicit GeosWriter(GEOSContextHandle_t context) : context_(context) {}

  [[nodiscard]] GeosGeometry write(const Geometry& from) const {
    std::vector<GeosGeometry> areas;
    for (const std::size_t polygon : polygons_of(from.region)) {
      areas.push_back(write_polygon(from.region, polygon));
    }
    std::vector<GeosGeometry> lines;
    for (const Polyline& line : from.polylines) lines.push_back(write_line(line, lines.size()));
    std::vector<GeosGeometry> points;
    for (const Point& point : from.points) {
      points.push_back(owned(GEOSGeom_createPoint_r(
          context_, sequence({{nearest_double(point.x, {}), nearest_double(point.y, {})}}))));
    }
    std::vector<GeosGeometry> kinds;
    const auto add = [&](std::vector<GeosGeometry>& parts, int type) {
      if (parts.size() == 1) kinds.push_back(std::move(parts.front()));
      if (parts.size() > 1) kinds.push_back(collect(parts, type));
    };
    add(areas, GEOS_MULTIPOLYGON);
    add(lines, GEOS_MULTILINESTRING);
    add(points, GEOS_MULTIPOINT);
    if (kinds.empty()) return owned(GEOSGeom_createEmptyPolygon_r(context_));
    if (kinds.size() == 1) return std::move(kinds.front());
    return collect(kinds, GEOS_GEOMETRYCOLLECTION);
  }

 private:
  [[nodiscard]] GeosGeometry owned(GEOSGeometry* geometry) const {
    if (geometry == nullptr) reject("GEOS refuses a geometry; its context has the message");
    return {geometry, GeosDeleter{context_}};
  }
  /// Returns points that the caller gives to a geometry at once. That geometry owns them then.
  [[nodiscard]] GEOSCoordSequence* sequence(const std::vector<GeosPoint>& points) const {
    std::unique_ptr<GEOSCoordSequence, GeosSequenceDeleter> made(
        GEOSCoordSeq_create_r(context_, static_cast<unsigned>(points.size()), 2), {context_});
    bool good = made != nullptr;
    for (unsigned i = 0; good && i < points.size(); ++i) {
      good = GEOSCoordSeq_setXY_r(context_, made.get(), i, points[i].x, points[i].y) != 0;
    }
    if (!good) reject("GEOS does not take the points of a geometry");
    return made.release();
  }
  [[nodiscard]] GeosGeometry write_ring(const Region& region, const Culprit& place) const {
    std::vector<GeosPoint> points;
    for_each_vertex<double>(region, place, place.ring == 0 ? 1 : -1, nullptr,
                            [&points](double x, double y) {
                              points.push_back({x, y});
                            });
    if (points.size() < 3) {
      reject("a ring of fewer than three vertices is no ring of GEOS: " + detail::to_string(place),
             place);
    }
    const GeosPoint first = points.front();
    points.push_back(first);
    return owned(GEOSGeom_createLinearRing_r(context_, sequence(points)));
  }
  [[nodiscard]] GeosGeometry write_polygon(const Region& region, std::size_t polygon) const {
    GeosGeometry outer;
    std::vector<GeosGeometry> holes;
    for (const Culprit& place : rings_of(region, polygon)) {
      GeosGeometry ring = write_ring(region, place);
      if (place.ring == 0) {
        outer = std::move(ring);
      } else {
        holes.push_back(std::move(ring));
      }
    }
    std::vector<GEOSGeometry*> given = release(holes);
    return owned(GEOSGeom_createPolygon_r(context_, outer.release(), given.data(),
                                          static_cast<unsigned>(given.size())));
  }
  [[nodiscard]] GeosGeometry write_line(const Polyline& line, std::size_t index) const {
    if (line.size() < 2) {
      reject("a polyline of fewer than two vertices is no line of GEOS: polyline " +
             std::to_string(index));
    }
    std::vector<GeosPoint> points;
    points.reserve(line.size());
    for (const Point& point : line) {
      points.push_back({nearest_double(point.x, {}), nearest_double(point.y, {})});
    }
    return owned(GEOSGeom_createLineString_r(context_, sequence(points)));
  }
  [[nodiscard]] GeosGeometry collect(std::vector<GeosGeometry>& parts, int type) const {
    std::vector<GEOSGeometry*> given = release(parts);
    return owned(GEOSGeom_createCollection_r(context_, type, given.data(),
                                             static_cast<unsigned>(given.size())));
  }
  static std::vector<GEOSGeometry*> release(std::vector<GeosGeometry>& parts) {
    std::vector<GEOSGeometry*> given;
    given.reserve(parts.size());
    for (GeosGeometry& part : parts) given.push_back(part.release());
    return given;
  }

  GEOSContextHandle_t context_;
};

}  // namespace detail

/// Returns the geometry of a point, a line, a polygon, several of these, or a collection, vertex by
/// vertex.
///
/// Doubles are taken exactly, and Z and M are not read. Rings of polygons lose the closing point
/// and keep their orientation. Closed lines, also a LinearRing, keep the closing point. Collections
/// may be nested, and mean the union of what they hold. Empty parts and empty holes are left out.
/// Nothing else is checked: ask `validate`, or let the operations refuse or resolve what is not
/// valid. The geometry of GEOS still belongs to its owner.
///
/// O(n) for n points. Throws Error(kBadInput): for NaN and infinity, with polygon (among those with
/// points), ring and vertex; for a polygon with holes and an empty outer ring; for a null pointer;
/// for curves and other types that are not named here.
[[nodiscard]] inline Geometry from_geos(GEOSContextHandle_t context, const GEOSGeometry* geometry) {
  detail::GeosReader reader(context);
  reader.read(geometry);
  return reader.take();
}

/// Returns a geometry in GEOS: POLYGON or MULTIPOLYGON, LINESTRING or MULTILINESTRING, POINT or
/// MULTIPOINT, or a GEOMETRYCOLLECTION of these if there are several kinds. An empty geometry is
/// POLYGON EMPTY.
///
/// Coordinates are the nearest doubles. Rounding may make rings cross, so call `round` (round.hpp)
/// first, which keeps them valid. Rings are closed, outer ones counter-clockwise and holes
/// clockwise. Rings and polygons without vertices are left out. A valid region gives a polygon that
/// is valid in GEOS, with one exception: here, rings of one polygon may touch at several points.
///
/// O(n) for n vertices. The context must live longer than the result. Throws Error: kBadInput for a
/// ring of fewer than three vertices, with polygon and ring; kBadInput for a polyline of fewer than
/// two vertices, and where GEOS refuses, whose context then has the message; kLimitExceeded for a
/// coordinate beyond the range of doubles.
[[nodiscard]] inline GeosGeometry to_geos(GEOSContextHandle_t context, const Geometry& geometry) {
  return detail::GeosWriter(context).write(geometry);
}

}  // namespace minksum::adaptors

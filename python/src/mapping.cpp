#include "mapping.hpp"

#include <nanobind/stl/string.h>

#include <string>
#include <utility>

#include "errors.hpp"
#include "numbers.hpp"

namespace nb = nanobind;

namespace minksum::python {
namespace {

// As deep as the readers of texts go.
constexpr int kMaxDepth = 32;

bool is_text(nb::handle object) {
  return PyUnicode_Check(object.ptr()) || PyBytes_Check(object.ptr());
}

bool is_number(nb::handle object) {
  return !is_text(object) &&
         (PyFloat_Check(object.ptr()) || PyLong_Check(object.ptr()) ||
          nb::hasattr(object, "numerator") || nb::hasattr(object, "as_integer_ratio"));
}

/// Where a vertex stands: in a ring, or in a part that has no area and that a text names.
struct Where {
  Culprit culprit;
  std::string part;
};

Where in_ring(const Region& region) {
  Where where;
  where.culprit.polygon = region.polygon_count() - 1;
  const IndexRange rings = region.rings_of(where.culprit.polygon);
  where.culprit.ring = rings.size() - 1;
  where.culprit.vertex = region.vertices_of(rings.front() + where.culprit.ring).size();
  return where;
}

Point plain_vertex(nb::handle point, bool drop_z) {
  if (!is_sequence(point) || nb::len(point) < 2) {
    throw nb::type_error("a vertex must be a pair of numbers (x, y)");
  }
  if (nb::len(point) > 2 && !drop_z) {
    throw Error(ErrorCode::kBadInput,
                "a vertex has more than two coordinates: z=\"drop\" drops what is beyond x and y");
  }
  return {require_number(point[0], "x"), require_number(point[1], "y")};
}

/// Reads a vertex. What it throws says where the vertex stands, as `where()` tells.
template <class Place>
Point exact_vertex(nb::handle point, bool drop_z, const Place& place) {
  try {
    return plain_vertex(point, drop_z);
  } catch (const Error& error) {
    const Where where = place();
    throw Error(error.code(), where.part + error.what(), where.culprit);
  } catch (const nb::builtin_exception& error) {
    const Where where = place();
    throw nb::type_error((where.part + error.what() + place_text(where.culprit)).c_str());
  }
}

/// Throws TypeError unless an object has elements, as lists, tuples and arrays have.
nb::handle elements(nb::handle object, const char* what) {
  if (PySequence_Check(object.ptr()) != 0 && !is_text(object)) return object;
  const std::string message = std::string(what) + " must be a sequence, not " +
                              nb::cast<std::string>(object.type().attr("__name__"));
  throw nb::type_error(message.c_str());
}

/// Appends a ring. It may repeat its first vertex at its end, as GeoJSON has it.
void append_ring(Region& region, nb::handle ring, bool drop_z) {
  region.begin_ring();
  std::size_t count = nb::len(elements(ring, "a ring"));
  if (count > 1 && ring[0].equal(ring[count - 1])) --count;
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = exact_vertex(ring[i], drop_z, [&region] { return in_ring(region); });
    region.add_vertex(at.x, at.y);
  }
}

void append_polygon(Region& region, nb::handle rings, bool drop_z) {
  if (nb::len(elements(rings, "a polygon")) == 0) return;
  region.begin_polygon();
  for (nb::handle ring : rings) append_ring(region, ring, drop_z);
}

void append_polyline(Geometry& geometry, nb::handle points, bool drop_z) {
  Polyline line;
  for (nb::handle point : elements(points, "a polyline")) {
    line.push_back(exact_vertex(point, drop_z, [&] {
      return Where{{-1, Culprit::kNone, Culprit::kNone, line.size()},
                   "polyline " + std::to_string(geometry.polylines.size()) + ": "};
    }));
  }
  geometry.polylines.push_back(std::move(line));
}

void append_point(Geometry& geometry, nb::handle point, bool drop_z) {
  geometry.points.push_back(exact_vertex(point, drop_z, [&geometry] {
    return Where{{}, "point " + std::to_string(geometry.points.size()) + ": "};
  }));
}

void append_coordinates(Geometry& geometry, const std::string& type, nb::handle coordinates,
                        bool drop_z) {
  const nb::handle parts = elements(coordinates, "the coordinates");
  if (type == "Polygon") {
    append_polygon(geometry.region, parts, drop_z);
  } else if (type == "MultiPolygon") {
    for (nb::handle polygon : parts) append_polygon(geometry.region, polygon, drop_z);
  } else if (type == "LineString" || type == "LinearRing") {
    if (nb::len(parts) > 0) append_polyline(geometry, parts, drop_z);
  } else if (type == "MultiLineString") {
    for (nb::handle line : parts) append_polyline(geometry, line, drop_z);
  } else if (type == "Point") {
    if (nb::len(parts) > 0) append_point(geometry, parts, drop_z);
  } else if (type == "MultiPoint") {
    for (nb::handle point : parts) append_point(geometry, point, drop_z);
  } else {
    throw Error(ErrorCode::kBadInput, "'" + type + "' is not a type of geometry that is read");
  }
}

nb::object member(nb::handle mapping, const std::string& type, const char* name) {
  nb::object value = nb::steal(PyObject_GetItem(mapping.ptr(), nb::str(name).ptr()));
  if (value.is_valid()) return value;
  if (PyErr_ExceptionMatches(PyExc_KeyError) == 0) throw nb::python_error();
  PyErr_Clear();
  throw Error(ErrorCode::kBadInput,
              "a mapping of the type '" + type + "' has no member \"" + std::string(name) + '"');
}

void append_mapping(Geometry& geometry, nb::handle mapping, bool drop_z, int depth) {
  if (depth > kMaxDepth) {
    throw Error(ErrorCode::kLimitExceeded,
                "collections are nested deeper than the limit of " + std::to_string(kMaxDepth), {},
                {},
                ExceededLimit{"io::ReadOptions::max_depth", static_cast<std::uint64_t>(kMaxDepth)});
  }
  if (!nb::hasattr(mapping, "get") || !nb::hasattr(mapping, "__getitem__")) {
    const std::string message = "a geometry of GeoJSON must be a mapping, not " +
                                nb::cast<std::string>(mapping.type().attr("__name__"));
    throw nb::type_error(message.c_str());
  }
  const nb::object type_object = mapping.attr("get")("type");
  if (!nb::isinstance<nb::str>(type_object)) {
    throw Error(ErrorCode::kBadInput, "the mapping has no member \"type\" that is a text");
  }
  const std::string type = utf8(type_object);
  const auto each = [&](const char* name) {
    const nb::object parts = member(mapping, type, name);
    for (nb::handle part : elements(parts, name)) {
      append_mapping(geometry, part, drop_z, depth + 1);
    }
  };
  if (type == "FeatureCollection") return each("features");
  if (type == "GeometryCollection") return each("geometries");
  if (type == "Feature") {
    const nb::object part = member(mapping, type, "geometry");
    if (!part.is_none()) append_mapping(geometry, part, drop_z, depth + 1);
    return;
  }
  append_coordinates(geometry, type, member(mapping, type, "coordinates"), drop_z);
}

}  // namespace

bool is_sequence(nb::handle object) {
  return nb::isinstance<nb::list>(object) || nb::isinstance<nb::tuple>(object);
}

bool is_point(nb::handle object) {
  return is_sequence(object) && nb::len(object) >= 2 && is_number(object[0]);
}

ShapePtr shape_of_ring(nb::handle ring, bool drop_z) {
  auto shape = std::make_shared<Shape>();
  shape->geometry.region.begin_polygon();
  append_ring(shape->geometry.region, ring, drop_z);
  return shape;
}

ShapePtr shape_of_mapping(nb::handle mapping, bool drop_z) {
  auto shape = std::make_shared<Shape>();
  append_mapping(shape->geometry, mapping, drop_z, 0);
  return shape;
}

}  // namespace minksum::python

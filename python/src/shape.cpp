#include "shape.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <minksum/io.hpp>
#include <utility>

#include "numbers.hpp"

namespace nb = nanobind;

namespace minksum::python {
namespace {

bool is_text(nb::handle object) {
  return PyUnicode_Check(object.ptr()) || PyBytes_Check(object.ptr());
}

/// Tells whether the class of an object is of a package, without importing it.
bool is_of(nb::handle object, const char* package) {
  const nb::object module = nb::getattr(object.type(), "__module__", nb::none());
  if (!nb::isinstance<nb::str>(module)) return false;
  const auto name = nb::cast<std::string>(module);
  const std::string_view prefix(package);
  return name.starts_with(prefix) && (name.size() == prefix.size() || name[prefix.size()] == '.');
}

/// Returns an attribute, or no object if there is none. Whatever else the attribute raises, it
/// raises.
nb::object attribute(nb::handle object, const char* name) {
  nb::object value = nb::steal(PyObject_GetAttrString(object.ptr(), name));
  if (value.is_valid()) return value;
  if (PyErr_ExceptionMatches(PyExc_AttributeError) == 0) throw nb::python_error();
  PyErr_Clear();
  return value;
}

bool is_number(nb::handle object) {
  return !is_text(object) &&
         (PyFloat_Check(object.ptr()) || PyLong_Check(object.ptr()) ||
          nb::hasattr(object, "numerator") || nb::hasattr(object, "as_integer_ratio"));
}

bool is_sequence(nb::handle object) {
  return nb::isinstance<nb::list>(object) || nb::isinstance<nb::tuple>(object);
}

/// Tells whether an object is a pair of numbers, perhaps with more behind them.
bool is_point(nb::handle object) {
  return is_sequence(object) && nb::len(object) >= 2 && is_number(object[0]);
}

template <class Number>
Shape ring_of(const nb::ndarray<const Number, nb::ndim<2>, nb::device::cpu>& points) {
  Shape shape;
  shape.geometry.region.begin_polygon();
  shape.geometry.region.begin_ring();
  const auto at = points.view();
  std::size_t count = points.shape(0);
  const auto same = [&at](std::size_t i, std::size_t j) {
    return at(i, 0) == at(j, 0) && at(i, 1) == at(j, 1);
  };
  if (count > 1 && same(0, count - 1)) --count;
  for (std::size_t i = 0; i < count; ++i) {
    shape.geometry.region.add_vertex(at(i, 0), at(i, 1));
  }
  return shape;
}

Point exact_vertex(nb::handle point, bool drop_z, const Region& region) {
  if (!is_sequence(point) || nb::len(point) < 2) {
    throw nb::type_error("a vertex must be a pair of numbers (x, y)");
  }
  if (nb::len(point) > 2 && !drop_z) {
    throw Error(ErrorCode::kBadInput,
                "a vertex has more than two coordinates: z=\"drop\" drops what is beyond x and y");
  }
  try {
    return {require_number(point[0], "x"), require_number(point[1], "y")};
  } catch (const Error& error) {
    Culprit place;
    if (region.polygon_count() > 0) {
      place.polygon = region.polygon_count() - 1;
      const IndexRange rings = region.rings_of(place.polygon);
      place.ring = rings.size() - 1;
      place.vertex = region.vertices_of(rings.front() + place.ring).size();
    }
    throw Error(error.code(), error.what(), place);
  }
}

/// Appends a ring. It may repeat its first vertex at its end, as GeoJSON has it.
void append_ring(Region& region, nb::handle ring, bool drop_z) {
  region.begin_ring();
  std::size_t count = nb::len(ring);
  if (count > 1 && ring[0].equal(ring[count - 1])) --count;
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = exact_vertex(ring[i], drop_z, region);
    region.add_vertex(at.x, at.y);
  }
}

void append_polygon(Region& region, nb::handle rings, bool drop_z) {
  if (nb::len(rings) == 0) return;
  region.begin_polygon();
  for (nb::handle ring : rings) append_ring(region, ring, drop_z);
}

Polyline polyline_of(nb::handle points, bool drop_z) {
  Polyline line;
  for (nb::handle point : points) line.push_back(exact_vertex(point, drop_z, Region()));
  return line;
}

void append_mapping(Geometry& geometry, nb::handle mapping, bool drop_z);

void append_coordinates(Geometry& geometry, const std::string& type, nb::handle coordinates,
                        bool drop_z) {
  if (type == "Polygon") {
    append_polygon(geometry.region, coordinates, drop_z);
  } else if (type == "MultiPolygon") {
    for (nb::handle polygon : coordinates) append_polygon(geometry.region, polygon, drop_z);
  } else if (type == "LineString" || type == "LinearRing") {
    if (nb::len(coordinates) > 0) geometry.polylines.push_back(polyline_of(coordinates, drop_z));
  } else if (type == "MultiLineString") {
    for (nb::handle line : coordinates) geometry.polylines.push_back(polyline_of(line, drop_z));
  } else if (type == "Point") {
    if (nb::len(coordinates) > 0) {
      geometry.points.push_back(exact_vertex(coordinates, drop_z, Region()));
    }
  } else if (type == "MultiPoint") {
    for (nb::handle point : coordinates) {
      geometry.points.push_back(exact_vertex(point, drop_z, Region()));
    }
  } else {
    throw Error(ErrorCode::kBadInput, "'" + type + "' is not a type of geometry that is read");
  }
}

void append_mapping(Geometry& geometry, nb::handle mapping, bool drop_z) {
  const nb::object type_object = mapping.attr("get")("type");
  if (!nb::isinstance<nb::str>(type_object)) {
    throw Error(ErrorCode::kBadInput, "the mapping has no member \"type\" that is a text");
  }
  const auto type = nb::cast<std::string>(type_object);
  const auto each = [&](const char* member) {
    for (nb::handle part : mapping[member]) append_mapping(geometry, part, drop_z);
  };
  if (type == "FeatureCollection") return each("features");
  if (type == "GeometryCollection") return each("geometries");
  if (type == "Feature") {
    const nb::object part = mapping["geometry"];
    if (!part.is_none()) append_mapping(geometry, part, drop_z);
    return;
  }
  append_coordinates(geometry, type, mapping["coordinates"], drop_z);
}

/// Returns the ring of an array of NumPy, or nothing if the array is not one of numbers.
ShapePtr shape_of_array(nb::handle object) {
  nb::ndarray<const double, nb::ndim<2>, nb::device::cpu> doubles;
  nb::ndarray<const std::int64_t, nb::ndim<2>, nb::device::cpu> integers;
  const auto two_columns = [](const auto& array) {
    if (array.shape(1) != 2) {
      throw nb::type_error("an array of numbers must have the shape (n, 2): one ring");
    }
  };
  if (nb::try_cast(object, doubles, false)) {
    two_columns(doubles);
    return std::make_shared<Shape>(ring_of(doubles));
  }
  if (nb::try_cast(object, integers, false)) {
    two_columns(integers);
    return std::make_shared<Shape>(ring_of(integers));
  }
  return nullptr;
}

Operands single(ShapePtr shape) {
  Operands operands;
  operands.array.items.push_back(std::move(shape));
  operands.scalar = true;
  return operands;
}

nb::object wkb_of_shapely(nb::handle objects) {
  return nb::module_::import_("shapely").attr("to_wkb")(objects, nb::arg("include_srid") = true,
                                                        nb::arg("output_dimension") = 4);
}

/// Tells whether all elements of a list are geometries of Shapely or missing.
bool all_of_shapely(const nb::list& objects) {
  for (nb::handle object : objects) {
    if (!object.is_none() && !is_of(object, "shapely")) return false;
  }
  return true;
}

Operands list_of(nb::handle objects, bool drop_z) {
  Operands operands;
  for (nb::handle object : objects) {
    operands.array.items.push_back(operand_of(object, drop_z));
  }
  operands.array.shape = {operands.array.items.size()};
  return operands;
}

/// Reads an array of NumPy whose elements are objects, or whose dtype is not handled directly.
Operands elements_of(nb::handle array, bool drop_z) {
  const nb::object kind = array.attr("dtype").attr("kind");
  const auto letter = nb::cast<std::string>(kind);
  if (letter != "O" && letter != "S" && letter != "U") {
    return operands_of(array.attr("tolist")(), drop_z);
  }
  nb::object elements = array.attr("ravel")().attr("tolist")();
  if (letter == "O" && all_of_shapely(nb::borrow<nb::list>(elements))) {
    elements = wkb_of_shapely(array.attr("ravel")()).attr("tolist")();
  }
  Operands operands = list_of(elements, drop_z);
  operands.array.shape = nb::cast<std::vector<std::size_t>>(nb::list(array.attr("shape")));
  operands.scalar = operands.array.shape.empty();
  return operands;
}

ShapePtr shape_of_ring(nb::handle ring, bool drop_z) {
  auto shape = std::make_shared<Shape>();
  shape->geometry.region.begin_polygon();
  append_ring(shape->geometry.region, ring, drop_z);
  return shape;
}

ShapePtr shape_of_text(nb::handle object, bool drop_z) {
  if (PyBytes_Check(object.ptr())) {
    const auto bytes = nb::borrow<nb::bytes>(object);
    const std::string_view data(static_cast<const char*>(bytes.data()), bytes.size());
    return read_wkb(data, drop_z);
  }
  return read_shape(nb::cast<std::string>(object), drop_z);
}

ShapePtr shape_of_shapely(nb::handle object, bool drop_z) {
  // A geometry of Shapely is pickled as EWKB, in half of the time that `shapely.to_wkb` takes.
  const nb::object state = object.attr("__reduce__")();
  nb::tuple arguments;
  if (nb::isinstance<nb::tuple>(state) && nb::len(state) > 1 &&
      nb::try_cast(state[1], arguments, false) && arguments.size() == 1) {
    const nb::object wkb = arguments[0];
    if (PyBytes_Check(wkb.ptr())) return shape_of_text(wkb, drop_z);
  }
  return shape_of_text(wkb_of_shapely(object), drop_z);
}

}  // namespace

bool drops_z(const std::string& z) {
  if (z != "error" && z != "drop") throw nb::value_error("z must be \"error\" or \"drop\"");
  return z == "drop";
}

ShapePtr read_wkb(std::string_view bytes, bool drop_z) {
  if (bytes.empty()) throw Error(ErrorCode::kBadInput, "byte 1: WKB is expected, found no bytes");
  if (bytes[0] != 0 && bytes[0] != 1) {
    throw Error(ErrorCode::kBadInput, "byte 1: WKB is expected, which begins with 0 or 1");
  }
  return read_shape(bytes, drop_z);
}

ShapePtr read_shape(std::string_view text, bool drop_z) {
  io::ReadOptions options;
  options.drop_z = drop_z;
  const io::Format format = io::detect_format(text);
  if (format != io::Format::kWkt && format != io::Format::kWkb && format != io::Format::kGeoJson) {
    throw Error(ErrorCode::kBadInput,
                "the text is not WKT, WKB or GeoJSON; minksum.io has functions for other formats");
  }
  io::Document document = io::read_document(text, options);
  return std::make_shared<Shape>(
      Shape{std::move(document.geometry), document.source.srid.value_or(0)});
}

ShapePtr shape_of_mapping(nb::handle mapping, bool drop_z) {
  auto shape = std::make_shared<Shape>();
  append_mapping(shape->geometry, mapping, drop_z);
  return shape;
}

Operands operands_of(nb::handle object, bool drop_z) {
  if (object.is_none()) return single(nullptr);
  ShapePtr shape;
  if (nb::try_cast(object, shape, false)) return single(std::move(shape));
  ShapeArrayPtr array;
  if (nb::try_cast(object, array, false)) return {*array, false};
  if (is_text(object)) return single(shape_of_text(object, drop_z));
  if (is_of(object, "shapely")) return single(shape_of_shapely(object, drop_z));
  if (is_of(object, "geopandas") && nb::hasattr(object, "to_numpy")) {
    return elements_of(object.attr("to_numpy")(), drop_z);
  }
  if (nb::hasattr(object, "dtype") && nb::hasattr(object, "ravel")) {
    ShapePtr ring = shape_of_array(object);
    return ring ? single(std::move(ring)) : elements_of(object, drop_z);
  }
  if (nb::isinstance<nb::dict>(object)) return single(shape_of_mapping(object, drop_z));
  const nb::object mapping = attribute(object, "__geo_interface__");
  if (mapping.is_valid()) return single(shape_of_mapping(mapping, drop_z));
  if (is_sequence(object)) {
    if (nb::len(object) > 0 && is_point(object[0])) return single(shape_of_ring(object, drop_z));
    return list_of(object, drop_z);
  }
  const std::string message =
      "a geometry is expected, not " + nb::cast<std::string>(object.type().attr("__name__"));
  throw nb::type_error(message.c_str());
}

ShapePtr operand_of(nb::handle object, bool drop_z) {
  Operands operands = operands_of(object, drop_z);
  if (!operands.scalar) throw nb::type_error("a single geometry is expected, not an array");
  return std::move(operands.array.items.front());
}

Argument::Argument(nb::handle object) : object_(object) {
  if (nb::isinstance<Shape>(object)) {
    shape_ = nb::inst_ptr<Shape>(object);
  } else {
    operands_ = operands_of(object);
  }
}

const Operands& Argument::array() const {
  if (operands_.array.items.empty() && shape_ != nullptr) operands_ = operands_of(object_);
  return operands_;
}

nb::object to_object(Shape shape) { return nb::cast(std::move(shape)); }

nb::object to_object(const ShapePtr& shape) { return shape ? nb::cast(shape) : nb::none(); }

nb::object to_object(ShapeArray array) {
  return nb::cast(std::make_shared<ShapeArray>(std::move(array)));
}

}  // namespace minksum::python

#include "shape.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <minksum/io.hpp>
#include <utility>

#include "call.hpp"
#include "errors.hpp"
#include "mapping.hpp"
#include "once.hpp"

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

/// Returns the ring of an array of NumPy, or nothing if the array is not one of pairs of numbers.
ShapePtr shape_of_array(nb::handle object) {
  nb::ndarray<const double, nb::ndim<2>, nb::device::cpu> doubles;
  nb::ndarray<const std::int64_t, nb::ndim<2>, nb::device::cpu> integers;
  if (nb::try_cast(object, doubles, false) && doubles.shape(1) == 2) {
    return std::make_shared<Shape>(ring_of(doubles));
  }
  if (nb::try_cast(object, integers, false) && integers.shape(1) == 2) {
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

/// Tells whether an object can be no single geometry. Arrays of objects are taken for arrays.
bool is_array(nb::handle object) {
  if (is_sequence(object)) return nb::len(object) == 0 || !is_point(object[0]);
  if (!nb::hasattr(object, "dtype") || !nb::hasattr(object, "ndim")) return false;
  const nb::object dimensions = object.attr("ndim");
  return nb::getattr(object.attr("dtype"), "kind", nb::str("O")).equal(nb::str("O")) ||
         (dimensions.not_equal(nb::int_(0)) && dimensions.not_equal(nb::int_(2)));
}

/// Reads the elements of a list. A list in a list is refused, which also ends one that contains
/// itself.
Operands list_of(nb::handle objects, Reading reading) {
  Operands operands;
  for (nb::handle object : objects) {
    try {
      if (is_array(object)) throw nb::type_error("a single geometry is expected, not an array");
      operands.array.items.push_back(operand_of(object, reading));
    } catch (...) {
      if (reading.forgive && is_bad_element()) {
        operands.array.items.push_back(nullptr);
        continue;
      }
      rethrow_at({operands.array.items.size()});
    }
  }
  operands.array.shape = {operands.array.items.size()};
  return operands;
}

/// Reads an array of NumPy whose elements are objects, or whose dtype is not handled directly.
Operands elements_of(nb::handle array, Reading reading) {
  const nb::object kind = array.attr("dtype").attr("kind");
  const auto letter = nb::cast<std::string>(kind);
  const auto shape = nb::cast<std::vector<std::size_t>>(nb::list(array.attr("shape")));
  if ((letter == "f" || letter == "i" || letter == "u") &&
      (shape.size() < 2 || shape.size() > 3 || shape.back() != 2)) {
    const std::string message =
        "an array of numbers must have the shape (n, 2), one ring, or "
        "(m, n, 2), m rings; not " +
        nb::cast<std::string>(nb::repr(nb::tuple(array.attr("shape"))));
    throw nb::type_error(message.c_str());
  }
  if (letter != "O" && letter != "S" && letter != "U") {
    return operands_of(array.attr("tolist")(), reading);
  }
  nb::object elements = array.attr("ravel")().attr("tolist")();
  // Numbers of other types, such as fractions, are objects to NumPy.
  if (letter == "O" && shape.size() >= 2 && nb::len(elements) >= shape.back() &&
      is_point(elements[nb::slice(std::size_t{0}, shape.back())])) {
    return operands_of(array.attr("tolist")(), reading);
  }
  if (letter == "O" && all_of_shapely(nb::borrow<nb::list>(elements))) {
    elements = wkb_of_shapely(array.attr("ravel")()).attr("tolist")();
  }
  try {
    Operands operands = list_of(elements, reading);
    operands.array.shape = shape;
    operands.scalar = shape.empty();
    return operands;
  } catch (const ElementError& error) {
    throw ElementError{error.error, place_in(shape, error.index.front()), error.operand};
  }
}

/// Gives elements the number of the reference system that a column of GeoPandas has.
Operands with_srid(Operands operands, nb::handle column) {
  const nb::object system = attribute(column, "crs");
  if (!system.is_valid() || system.is_none()) return operands;
  const nb::object number = system.attr("to_epsg")();
  if (number.is_none()) return operands;
  for (const ShapePtr& item : operands.array.items) {
    if (item && item->srid == 0) item->srid = nb::cast<std::int32_t>(number);
  }
  return operands;
}

ShapePtr shape_of_text(nb::handle object, bool drop_z) {
  if (PyBytes_Check(object.ptr())) {
    const auto bytes = nb::borrow<nb::bytes>(object);
    const std::string_view data(static_cast<const char*>(bytes.data()), bytes.size());
    return read_wkb(data, drop_z);
  }
  return read_shape(utf8(object), drop_z);
}

ShapePtr shape_of_shapely(nb::handle object, bool drop_z) {
  static nb::handle kept;
  const nb::handle writer =
      once(kept, [] { return nb::module_::import_("minksum._interop").attr("writer")(); });
  const auto parts = nb::borrow<nb::tuple>(writer);
  const nb::object wkb = parts.size() == 6
                             ? parts[0](object, parts[1], parts[2], parts[3], parts[4], parts[5])
                             : parts[0](object);
  return shape_of_text(wkb, drop_z);
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
  // What is not told for WKB by its first bytes must not be read as a text.
  if (io::detect_format(bytes) != io::Format::kWkb) {
    throw Error(ErrorCode::kBadInput, bytes.size() < 5
                                          ? "byte " + std::to_string(bytes.size() + 1) +
                                                ": the code of a type is expected, found the end"
                                          : "byte 2: the code of a type is expected");
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
  try {
    io::Document document = io::read_document(text, options);
    return std::make_shared<Shape>(
        Shape{std::move(document.geometry), document.source.srid.value_or(0)});
  } catch (const io::ReadError& error) {
    // The library names its own option.
    std::string message = error.what();
    const std::string_view option = "io::ReadOptions::drop_z keeps";
    const std::size_t at = message.find(option);
    if (at == std::string::npos) throw;
    message.replace(at, option.size(), "z=\"drop\" of as_geometry keeps");
    throw io::ReadError(error.code(), message, error.line(), error.column(), error.limit());
  }
}

Operands operands_of(nb::handle object, Reading reading) {
  const bool drop_z = reading.drop_z;
  if (object.is_none()) return single(nullptr);
  ShapePtr shape;
  if (nb::try_cast(object, shape, false)) return single(std::move(shape));
  ShapeArrayPtr array;
  if (nb::try_cast(object, array, false)) return {*array, false};
  if (is_text(object)) return single(shape_of_text(object, drop_z));
  if (is_of(object, "shapely")) return single(shape_of_shapely(object, drop_z));
  if (is_of(object, "geopandas") && nb::hasattr(object, "to_numpy")) {
    return with_srid(elements_of(object.attr("to_numpy")(), reading), object);
  }
  if (is_of(object, "numpy.ma")) throw nb::type_error("masked arrays are not read: fill them");
  if (nb::hasattr(object, "dtype") && nb::hasattr(object, "ravel")) {
    ShapePtr ring = shape_of_array(object);
    return ring ? single(std::move(ring)) : elements_of(object, reading);
  }
  if (nb::isinstance<nb::dict>(object)) return single(shape_of_mapping(object, drop_z));
  if (is_arrow(object)) return {shapes_of_arrow(object, reading), false};
  const nb::object mapping = attribute(object, "__geo_interface__");
  if (mapping.is_valid()) return single(shape_of_mapping(mapping, drop_z));
  if (is_sequence(object)) {
    if (nb::len(object) > 0 && is_point(object[0])) return single(shape_of_ring(object, drop_z));
    return list_of(object, reading);
  }
  const std::string message =
      "a geometry is expected, not " + nb::cast<std::string>(object.type().attr("__name__"));
  throw nb::type_error(message.c_str());
}

ShapePtr operand_of(nb::handle object, Reading reading) {
  Operands operands = operands_of(object, reading);
  if (!operands.scalar) throw nb::type_error("a single geometry is expected, not an array");
  return std::move(operands.array.items.front());
}

Argument::Argument(nb::handle object, int operand, bool forgive) : object_(object) {
  if (nb::isinstance<Shape>(object)) {
    if (!nb::inst_ready(object)) throw nb::type_error("a Geometry is not made: call __init__");
    shape_ = nb::inst_ptr<Shape>(object);
    return;
  }
  try {
    operands_ = operands_of(object, {false, forgive});
  } catch (...) {
    if (forgive && is_bad_element()) {
      operands_ = single(nullptr);
      return;
    }
    rethrow_at({}, operand);
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

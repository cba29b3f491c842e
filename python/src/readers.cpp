// Binds the functions that make geometries.
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <minksum/io.hpp>

#include "bindings.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "numbers.hpp"
#include "shape.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

using Offsets = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Coordinates = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Returns an argument as an array of numbers of one of some kinds, as NumPy names them.
nb::object numbers_of(nb::handle argument, const char* name, const char* kinds, const char* type,
                      int dimensions) {
  const nb::object numpy = nb::module_::import_("numpy");
  nb::object array = numpy.attr("asarray")(argument);
  const auto kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
  const bool empty = nb::cast<std::size_t>(array.attr("size")) == 0;
  if ((!empty && std::string_view(kinds).find(kind) == std::string_view::npos) ||
      array.attr("ndim").not_equal(nb::int_(dimensions))) {
    const std::string message = std::string(name) + " must be an array of " + type +
                                (dimensions == 1 ? " in one dimension" : " of the shape (n, 2)");
    throw nb::type_error(message.c_str());
  }
  nb::object converted =
      numpy.attr("ascontiguousarray")(array, dimensions == 1 ? "int64" : "float64");
  // Integers that no double has would be changed.
  if (dimensions == 2 && kind != "f" && !empty &&
      !nb::cast<bool>(
          numpy.attr("array_equal")(converted.attr("astype")(array.attr("dtype")), array))) {
    throw Error(ErrorCode::kBadInput, std::string(name) + " has integers that are no doubles");
  }
  return converted;
}

/// Returns offsets that begin with 0, do not decrease and end with `most`, the count of `things`.
std::span<const std::int64_t> checked(const Offsets& offsets, std::size_t most, const char* name,
                                      const char* things) {
  const std::span<const std::int64_t> all(offsets.data(), offsets.shape(0));
  const auto refuse = [&](std::size_t i, const std::string& fault) {
    throw Error(ErrorCode::kBadInput,
                std::string(name) + '[' + std::to_string(i) + "]" + fault + ": " + name +
                    " must begin with 0, must not decrease, and must end with the number of " +
                    things + ", " + std::to_string(most));
  };
  const auto number = [&all](std::size_t i) { return std::to_string(all[i]); };
  if (all.empty()) refuse(0, " is missing");
  if (all.front() != 0) refuse(0, " is " + number(0));
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i] < all[i - 1]) refuse(i, " is " + number(i) + " after " + number(i - 1));
  }
  const std::size_t last = all.size() - 1;
  if (static_cast<std::uint64_t>(all[last]) != most) refuse(last, " is " + number(last));
  return all;
}

/// Makes geometries of flat arrays, as `shapely.to_ragged_array` returns them for multipolygons.
ShapeArrayPtr from_ragged_array(nb::handle coords, nb::handle ring_offsets,
                                nb::handle polygon_offsets, nb::handle geometry_offsets) {
  const auto offsets_of = [](nb::handle argument, const char* name) {
    return nb::cast<Offsets>(numbers_of(argument, name, "iu", "integers", 1));
  };
  const auto coordinates = nb::cast<Coordinates>(numbers_of(coords, "coords", "fiu", "numbers", 2));
  if (coordinates.shape(1) != 2) {
    throw nb::type_error("coords must be an array of numbers of the shape (n, 2)");
  }
  const Offsets rings = offsets_of(ring_offsets, "ring_offsets");
  const Offsets polygons = offsets_of(polygon_offsets, "polygon_offsets");
  std::optional<Offsets> geometries;
  if (!geometry_offsets.is_none()) geometries = offsets_of(geometry_offsets, "geometry_offsets");
  const auto ring_starts = checked(rings, coordinates.shape(0), "ring_offsets", "vertices");
  const auto polygon_starts = checked(polygons, ring_starts.size() - 1, "polygon_offsets", "rings");
  std::vector<std::int64_t> each;
  std::span<const std::int64_t> starts;
  if (geometries) {
    starts = checked(*geometries, polygon_starts.size() - 1, "geometry_offsets", "polygons");
  } else {
    for (std::size_t p = 0; p < polygon_starts.size(); ++p) {
      each.push_back(static_cast<std::int64_t>(p));
    }
    starts = each;
  }
  auto array = std::make_shared<ShapeArray>();
  const double* xy = coordinates.data();
  const auto read = [&](Region& region, std::size_t g) {
    for (auto p = starts[g]; p < starts[g + 1]; ++p) {
      if (polygon_starts[p] == polygon_starts[p + 1]) continue;
      region.begin_polygon();
      for (auto r = polygon_starts[p]; r < polygon_starts[p + 1]; ++r) {
        region.begin_ring();
        std::int64_t end = ring_starts[r + 1];
        const std::int64_t begin = ring_starts[r];
        // Rings repeat their first vertex in these arrays; a region stores it once.
        if (end - begin > 1 && xy[2 * begin] == xy[2 * end - 2] &&
            xy[2 * begin + 1] == xy[2 * end - 1]) {
          --end;
        }
        for (std::int64_t v = begin; v < end; ++v) region.add_vertex(xy[2 * v], xy[2 * v + 1]);
      }
    }
  };
  for (std::size_t g = 0; g + 1 < starts.size(); ++g) {
    auto shape = std::make_shared<Shape>();
    try {
      read(shape->geometry.region, g);
    } catch (...) {
      rethrow_at({g});
    }
    array->items.push_back(std::move(shape));
  }
  array->shape = {array->items.size()};
  return array;
}

template <class Number>
nb::object numpy_array(std::vector<Number> values, std::size_t columns) {
  auto* kept = new std::vector<Number>(std::move(values));
  const nb::capsule owner(kept,
                          [](void* p) noexcept { delete static_cast<std::vector<Number>*>(p); });
  if (columns == 1) {
    return nb::cast(
        nb::ndarray<nb::numpy, Number, nb::ndim<1>>(kept->data(), {kept->size()}, owner));
  }
  return nb::cast(nb::ndarray<nb::numpy, Number, nb::ndim<2>>(
      kept->data(), {kept->size() / columns, columns}, owner));
}

nb::tuple to_ragged_array(const ShapeArray& array) {
  std::vector<double> coordinates;
  std::vector<std::int64_t> rings{0};
  std::vector<std::int64_t> polygons{0};
  std::vector<std::int64_t> geometries{0};
  for (const ShapePtr& item : array.items) {
    if (!item || item->geometry.has_thin_parts()) {
      const std::string message =
          "element " + std::to_string(geometries.size() - 1) +
          (item ? " has polylines or points: these flat arrays hold polygons alone"
                : " is missing: flat arrays have no missing geometries");
      throw nb::value_error(message.c_str());
    }
    const Region& region = item->geometry.region;
    for (const std::size_t polygon : region.polygons()) {
      for (const std::size_t ring : region.rings_of(polygon)) {
        const IndexRange vertices = region.vertices_of(ring);
        const auto append = [&](std::size_t v) {
          coordinates.push_back(region.x(v));
          coordinates.push_back(region.y(v));
        };
        for (const std::size_t v : vertices) append(v);
        if (!vertices.empty()) append(vertices.front());
        rings.push_back(static_cast<std::int64_t>(coordinates.size() / 2));
      }
      polygons.push_back(static_cast<std::int64_t>(rings.size() - 1));
    }
    geometries.push_back(static_cast<std::int64_t>(polygons.size() - 1));
  }
  return nb::make_tuple(
      numpy_array(std::move(coordinates), 2),
      nb::make_tuple(numpy_array(std::move(rings), 1), numpy_array(std::move(polygons), 1),
                     numpy_array(std::move(geometries), 1)));
}

Shape box(nb::handle x0, nb::handle y0, nb::handle x1, nb::handle y1) {
  const Rational left = require_number(x0, "xmin");
  const Rational low = require_number(y0, "ymin");
  const Rational right = require_number(x1, "xmax");
  const Rational high = require_number(y1, "ymax");
  if (left >= right || low >= high) {
    throw Error(ErrorCode::kBadInput, "a box needs xmin < xmax and ymin < ymax");
  }
  return {Region(Polygon{{{left, low}, {right, low}, {right, high}, {left, high}}}), 0};
}

ShapePtr read_drawing(const std::string& text, nb::handle tolerance, const std::string& side,
                      const std::string& layer, nb::handle join_ends, io::Format format) {
  io::ReadOptions options;
  if (!tolerance.is_none()) options.drawing.tolerance = require_number(tolerance, "tolerance");
  options.drawing.side = side_of(side);
  options.drawing.layer = layer;
  options.drawing.join_ends = require_number(join_ends, "join_ends");
  if (io::detect_format(text) != format) {
    throw Error(ErrorCode::kBadInput,
                format == io::Format::kSvg ? "the text is not SVG" : "the text is not DXF");
  }
  return std::make_shared<Shape>(Shape{io::read_geometry(text, options), 0});
}

}  // namespace

void bind_readers(nb::module_& m) {
  const auto texts = [](nb::handle text, const std::string& z, io::Format format) -> nb::object {
    const bool drop_z = drops_z(z);
    if (text.is_none()) return nb::none();
    if (PyUnicode_Check(text.ptr()) || PyBytes_Check(text.ptr())) {
      if (PyUnicode_Check(text.ptr()) ? io::detect_format(utf8(text)) != format
                                      : format != io::Format::kWkb) {
        throw Error(ErrorCode::kBadInput, "the text is in another format");
      }
      return to_object(operand_of(text, drop_z));
    }
    Operands operands = operands_of(text, drop_z);
    return operands.scalar ? to_object(operands.array.items.front())
                           : to_object(std::move(operands.array));
  };
  const auto def = [&](const char* name, io::Format format, const char* sig, const char* doc) {
    m.def(
        name,
        [texts, format](nb::handle text, const std::string& z) { return texts(text, z, format); },
        "text"_a.none(), nb::kw_only(), "z"_a = "error", nb::sig(sig), doc);
  };
  def("from_wkt", io::Format::kWkt,
      "def from_wkt(text: typing.Any, *, z: str = 'error') -> typing.Any",
      "Return the geometry of a text as WKT, whose numbers are exact and may be fractions; or an "
      "array of a sequence of texts.\n\n"
      "Examples\n--------\n>>> import minksum\n"
      ">>> minksum.from_wkt('POLYGON ((0 0, 1/3 0, 0 1, 0 0))')\n"
      "<minksum.Geometry POLYGON, 1 part, 3 vertices>");
  def("from_wkb", io::Format::kWkb,
      "def from_wkb(text: typing.Any, *, z: str = 'error') -> typing.Any",
      "Return the geometry of WKB or EWKB, as bytes or hexadecimal digits; or an array of a "
      "sequence of these.");
  m.def(
      "from_geojson",
      [texts](nb::handle object, const std::string& z) -> nb::object {
        if (nb::isinstance<nb::dict>(object)) {
          return to_object(shape_of_mapping(object, drops_z(z)));
        }
        return texts(object, z, io::Format::kGeoJson);
      },
      nb::arg("object").none(), nb::kw_only(), "z"_a = "error",
      nb::sig("def from_geojson(object: typing.Any, *, z: str = 'error') -> typing.Any"),
      "Return the geometry of GeoJSON: a text, whose numbers are exact decimals, or a mapping, "
      "whose floats are exactly themselves.");
  m.def(
      "as_geometry",
      [](nb::handle object, const std::string& z) -> nb::object {
        Operands operands = operands_of(object, drops_z(z));
        return operands.scalar ? to_object(operands.array.items.front())
                               : to_object(std::move(operands.array));
      },
      nb::arg("object").none(), nb::kw_only(), "z"_a = "error",
      nb::sig("def as_geometry(object: GeometryLike, *, z: str = 'error') -> typing.Any"),
      "Return the geometry, or the array, that an operand stands for.");
  m.def("from_ragged_array", from_ragged_array, "coords"_a.none(), "ring_offsets"_a.none(),
        "polygon_offsets"_a.none(), "geometry_offsets"_a = nb::none(),
        nb::sig("def from_ragged_array(coords: numpy.typing.NDArray[numpy.float64], "
                "ring_offsets: numpy.typing.NDArray[numpy.int64], "
                "polygon_offsets: numpy.typing.NDArray[numpy.int64], "
                "geometry_offsets: numpy.typing.NDArray[numpy.int64] | None = None) -> "
                "GeometryArray"),
        "Return an array of the polygons of flat arrays, as `shapely.to_ragged_array` makes them.");
  m.def("to_ragged_array", to_ragged_array, "array"_a,
        nb::sig("def to_ragged_array(array: GeometryArray) -> "
                "tuple[numpy.typing.NDArray[numpy.float64], "
                "tuple[numpy.typing.NDArray[numpy.int64], ...]]"),
        "Return coordinates and the offsets of rings, polygons and geometries, for "
        "`shapely.from_ragged_array(shapely.GeometryType.MULTIPOLYGON, ...)`.");
  m.def(
      "box",
      [](nb::handle x0, nb::handle y0, nb::handle x1, nb::handle y1) {
        return std::make_shared<Shape>(box(x0, y0, x1, y1));
      },
      "xmin"_a, "ymin"_a, "xmax"_a, "ymax"_a,
      nb::sig("def box(xmin: Number, ymin: Number, xmax: Number, ymax: Number) -> Geometry"),
      "Return an axis-parallel rectangle.");
  m.def(
      "disc",
      [](nb::handle radius, nb::handle tolerance, const std::string& side) {
        const Rational r = require_number(radius, "radius");
        const Rational t =
            tolerance.is_none() ? r / Rational(1000) : require_number(tolerance, "tolerance");
        return std::make_shared<Shape>(Shape{disc(r, t, side_of(side)), 0});
      },
      "radius"_a, "tolerance"_a = nb::none(), "side"_a = "nearest",
      nb::sig("def disc(radius: Number, tolerance: Number | None = None, side: str = 'nearest') "
              "-> Geometry"),
      "Return a convex polygon within the tolerance of the disc around the origin. By 'outside' "
      "it contains the disc, and by 'inside' it lies within it.");
  m.def(
      "_read_svg",
      [](const std::string& text, nb::handle tolerance, const std::string& side) {
        return read_drawing(text, tolerance, side, "", nb::int_(0), io::Format::kSvg);
      },
      "text"_a, "tolerance"_a.none(), "side"_a,
      nb::sig("def _read_svg(text: str, tolerance: Number | None, side: str) -> Geometry"));
  m.def(
      "_read_dxf",
      [](const std::string& text, nb::handle tolerance, const std::string& side,
         const std::string& layer, nb::handle join_ends) {
        return read_drawing(text, tolerance, side, layer, join_ends, io::Format::kDxf);
      },
      "text"_a, "tolerance"_a.none(), "side"_a, "layer"_a, "join_ends"_a,
      nb::sig("def _read_dxf(text: str, tolerance: Number | None, side: str, layer: str, "
              "join_ends: Number) -> Geometry"));
}

}  // namespace minksum::python

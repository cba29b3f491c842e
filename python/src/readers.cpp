// Binds the functions that make geometries.
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

ShapePtr read_drawing(const nb::bytes& bytes, nb::handle tolerance, const std::string& side,
                      const std::string& layer, nb::handle join_ends, io::Format format) {
  io::ReadOptions options;
  if (!tolerance.is_none()) options.drawing.tolerance = require_number(tolerance, "tolerance");
  options.drawing.side = side_of(side);
  options.drawing.layer = layer;
  options.drawing.join_ends = require_number(join_ends, "join_ends");
  const std::string_view text(static_cast<const char*>(bytes.data()), bytes.size());
  if (io::detect_format(text) != format) {
    throw Error(ErrorCode::kBadInput,
                format == io::Format::kSvg ? "the text is not SVG" : "the text is not DXF");
  }
  return std::make_shared<Shape>(Shape{io::read_geometry(text, options), 0});
}

}  // namespace

void bind_readers(nb::module_& m) {
  const auto texts = [](nb::handle text, Reading reading, io::Format format) -> nb::object {
    if (text.is_none()) return nb::none();
    if (PyUnicode_Check(text.ptr()) || PyBytes_Check(text.ptr())) {
      if (PyUnicode_Check(text.ptr()) ? io::detect_format(utf8(text)) != format
                                      : format != io::Format::kWkb) {
        throw Error(ErrorCode::kBadInput, "the text is in another format");
      }
      return to_object(operand_of(text, reading));
    }
    Operands operands = operands_of(text, reading);
    return operands.scalar ? to_object(operands.array.items.front())
                           : to_object(std::move(operands.array));
  };
  const auto def = [&](const char* name, io::Format format, const char* sig, const char* doc) {
    m.def(
        name,
        [texts, format](nb::handle text, const std::string& z, const std::string& on_error) {
          return texts(text, {drops_z(z), forgives(on_error)}, format);
        },
        "text"_a.none(), nb::kw_only(), "z"_a = "error", MINKSUM_ON_ERROR_ARG, nb::sig(sig), doc);
  };
  def("from_wkt", io::Format::kWkt,
      "def from_wkt(text: typing.Any, *, z: str = 'error', on_error: str = 'raise') -> typing.Any",
      "Return the geometry of a text as WKT, whose numbers are exact and may be fractions; or an "
      "array of a sequence of texts.\n\n"
      "Examples\n--------\n>>> import minksum\n"
      ">>> minksum.from_wkt('POLYGON ((0 0, 1/3 0, 0 1, 0 0))')\n"
      "<minksum.Geometry POLYGON, 1 part, 3 vertices>");
  def("from_wkb", io::Format::kWkb,
      "def from_wkb(text: typing.Any, *, z: str = 'error', on_error: str = 'raise') -> typing.Any",
      "Return the geometry of WKB or EWKB, as bytes or hexadecimal digits; or an array of a "
      "sequence of these.");
  m.def(
      "from_geojson",
      [texts](nb::handle object, const std::string& z, const std::string& on_error) -> nb::object {
        if (nb::isinstance<nb::dict>(object)) {
          return to_object(shape_of_mapping(object, drops_z(z)));
        }
        return texts(object, {drops_z(z), forgives(on_error)}, io::Format::kGeoJson);
      },
      nb::arg("object").none(), nb::kw_only(), "z"_a = "error", MINKSUM_ON_ERROR_ARG,
      nb::sig("def from_geojson(object: typing.Any, *, z: str = 'error', on_error: str = 'raise') "
              "-> typing.Any"),
      "Return the geometry of GeoJSON: a text, whose numbers are exact decimals, or a mapping, "
      "whose floats are exactly themselves.");
  m.def(
      "as_geometry",
      [](nb::handle object, const std::string& z, const std::string& on_error) -> nb::object {
        Operands operands = operands_of(object, {drops_z(z), forgives(on_error)});
        return operands.scalar ? to_object(operands.array.items.front())
                               : to_object(std::move(operands.array));
      },
      nb::arg("object").none(), nb::kw_only(), "z"_a = "error", MINKSUM_ON_ERROR_ARG,
      nb::sig("def as_geometry(object: GeometryLike, *, z: str = 'error', on_error: str = 'raise') "
              "-> typing.Any"),
      "Return the geometry, or the array, that an operand stands for.");
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
      [](const nb::bytes& text, nb::handle tolerance, const std::string& side) {
        return read_drawing(text, tolerance, side, "", nb::int_(0), io::Format::kSvg);
      },
      "text"_a, "tolerance"_a.none(), "side"_a,
      nb::sig("def _read_svg(text: bytes, tolerance: Number | None, side: str) -> Geometry"));
  m.def(
      "_read_dxf",
      [](const nb::bytes& text, nb::handle tolerance, const std::string& side,
         const std::string& layer, nb::handle join_ends) {
        return read_drawing(text, tolerance, side, layer, join_ends, io::Format::kDxf);
      },
      "text"_a, "tolerance"_a.none(), "side"_a, "layer"_a, "join_ends"_a,
      nb::sig("def _read_dxf(text: bytes, tolerance: Number | None, side: str, layer: str, "
              "join_ends: Number) -> Geometry"));
}

}  // namespace minksum::python

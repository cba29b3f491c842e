// Binds Geometry.
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <functional>
#include <minksum/io.hpp>
#include <optional>
#include <sstream>
#include <utility>

#include "bindings.hpp"
#include "call.hpp"
#include "elementwise.hpp"
#include "numbers.hpp"
#include "shape.hpp"
#include "state.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

io::Coordinates exact_style() {
  io::Coordinates style;
  style.style = io::Coordinates::Style::kExact;
  return style;
}

/// Doubles and decimals are written of a rounded set, so that what is written is valid.
Geometry writable(const Shape& shape, const std::string& side, const Options& options,
                  std::optional<int> decimals = {}) {
  RoundOptions target;
  target.side = side_of(side);
  target.decimals = decimals;
  if (shape.resolved && !shape.geometry.has_thin_parts()) {
    return round(shape.geometry, target, options);
  }
  return round_with_tight_places(shape.geometry, target, options);
}

/// Returns what `make` returns, and lets go of the interpreter's lock if that may take long.
template <class Make>
auto computed(const Shape& shape, const Make& make) {
  Call call;
  decltype(make(call.options())) made;
  call.run(is_small(shape.geometry), [&] { made = make(call.options()); });
  return made;
}

std::string geometry_type(const Geometry& geometry) {
  const std::size_t polygons = geometry.region.polygon_count();
  const int kinds = static_cast<int>(polygons > 0) + static_cast<int>(!geometry.polylines.empty()) +
                    static_cast<int>(!geometry.points.empty());
  if (kinds > 1) return "GeometryCollection";
  if (!geometry.polylines.empty()) {
    return geometry.polylines.size() == 1 ? "LineString" : "MultiLineString";
  }
  if (!geometry.points.empty()) return geometry.points.size() == 1 ? "Point" : "MultiPoint";
  return polygons > 1 ? "MultiPolygon" : "Polygon";
}

std::size_t vertex_count(const Geometry& geometry) {
  std::size_t count = geometry.region.vertex_count() + geometry.points.size();
  for (const Polyline& line : geometry.polylines) count += line.size();
  return count;
}

template <class Visit>
void for_each_vertex(const Geometry& geometry, const Visit& visit) {
  const Region& region = geometry.region;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) visit(region.x(v), region.y(v));
  const auto visit_exact = [&visit](const Point& p) { visit(p.x.to_double(), p.y.to_double()); };
  for (const Polyline& line : geometry.polylines) {
    for (const Point& p : line) visit_exact(p);
  }
  for (const Point& p : geometry.points) visit_exact(p);
}

nb::object coordinates(const Geometry& geometry) {
  auto* numbers = new std::vector<double>();
  const nb::capsule owner(numbers,
                          [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  numbers->reserve(2 * vertex_count(geometry));
  for_each_vertex(geometry, [numbers](double x, double y) {
    numbers->push_back(x);
    numbers->push_back(y);
  });
  return nb::cast(nb::ndarray<nb::numpy, double, nb::ndim<2>>(numbers->data(),
                                                              {numbers->size() / 2, 2}, owner));
}

template <class Points>
nb::list exact_list(const Points& points) {
  nb::list list;
  for (const Point& point : points) list.append(exact_point(point));
  return list;
}

nb::list exact_rings(const Region& region, std::size_t polygon) {
  nb::list rings;
  for (const std::size_t ring : region.rings_of(polygon)) {
    rings.append(exact_list(RingView(region, ring).exact_points()));
  }
  return rings;
}

nb::dict exact_coordinates(const Geometry& geometry) {
  nb::dict parts;
  nb::list polygons;
  for (const std::size_t p : geometry.region.polygons()) {
    polygons.append(exact_rings(geometry.region, p));
  }
  nb::list lines;
  for (const Polyline& line : geometry.polylines) lines.append(exact_list(line));
  parts["polygons"] = polygons;
  parts["polylines"] = lines;
  parts["points"] = exact_list(geometry.points);
  return parts;
}

std::size_t hash_of_vertices(const Geometry& geometry) {
  std::size_t hash = geometry.region.ring_count();
  for_each_vertex(geometry, [&hash](double x, double y) {
    hash = hash * 1000003U ^ std::hash<double>()(x);
    hash = hash * 1000003U ^ std::hash<double>()(y);
  });
  return hash;
}

std::string describe(const Geometry& geometry) {
  std::string type = geometry_type(geometry);
  std::string text = "<minksum.Geometry ";
  for (const char c : type) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (geometry.empty()) return text + " EMPTY>";
  const std::size_t parts =
      geometry.region.polygon_count() + geometry.polylines.size() + geometry.points.size();
  text += ", " + std::to_string(parts) + (parts == 1 ? " part, " : " parts, ");
  const std::size_t vertices = vertex_count(geometry);
  return text + std::to_string(vertices) + (vertices == 1 ? " vertex>" : " vertices>");
}

nb::object origins(const Geometry& geometry) {
  if (!geometry.region.has_origins()) return nb::none();
  nb::list list;
  for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
    const EdgeOrigin& origin = geometry.region.origin(v);
    list.append(nb::make_tuple(static_cast<int>(origin.edge_operand), origin.edge, origin.vertex));
  }
  return list;
}

std::string picture(const Shape& shape) {
  return computed(shape, [&](const Options& options) {
    std::ostringstream out;
    io::write(out, writable(shape, "nearest", options), io::Format::kSvg);
    return out.str();
  });
}

std::string geojson_of(const Shape& shape) {
  return computed(shape, [&](const Options& options) {
    return io::to_geojson(writable(shape, "nearest", options));
  });
}

std::string wkt_of(const Shape& shape, std::optional<int> decimals, const std::string& side) {
  io::Coordinates style;
  if (decimals) {
    style.style = io::Coordinates::Style::kDecimal;
    style.digits = *decimals;
  }
  return computed(shape, [&](const Options& options) {
    return io::to_wkt(writable(shape, side, options, decimals), style);
  });
}

void bind_conversions(nb::class_<Shape>& type) {
  type.def("to_wkt", wkt_of, nb::kw_only(), "decimals"_a = nb::none(), "round"_a = "nearest",
           "Return WKT of the rounded set, which is valid.\n\n"
           "Parameters\n----------\n"
           "decimals : int, optional\n    Digits after the point. Without it, doubles are "
           "written.\n"
           "round : {'nearest', 'outside', 'inside'}\n    The side to which the set is rounded.\n\n"
           "Examples\n--------\n>>> import minksum\n"
           ">>> minksum.from_wkt('POLYGON ((0 0, 1/3 0, 0 1, 0 0))').to_wkt(decimals=2)\n"
           "'POLYGON ((0.00 0.00, 0.33 0.00, 0.00 1.00, 0.00 0.00))'")
      .def(
          "to_wkb",
          [](const Shape& s, const std::string& round, bool include_srid) {
            const std::string wkb = computed(
                s, [&](const Options& options) { return wkb_of(s, round, include_srid, options); });
            return nb::bytes(wkb.data(), wkb.size());
          },
          nb::kw_only(), "round"_a = "nearest", "include_srid"_a = false,
          "Return little-endian WKB of the rounded set, which is valid.")
      .def(
          "to_geojson",
          [](const Shape& s, bool exact) {
            return exact ? io::to_geojson(s.geometry, exact_style()) : geojson_of(s);
          },
          nb::kw_only(), "exact"_a = false,
          "Return a GeoJSON geometry object as a text. With `exact`, fractions are strings.")
      .def("svg", picture, "Return a picture as SVG.")
      .def("_repr_svg_", picture)
      .def_prop_ro(
          "__geo_interface__",
          [](const Shape& s) { return nb::module_::import_("json").attr("loads")(geojson_of(s)); },
          nb::sig("def __geo_interface__(self) -> dict[str, typing.Any]"),
          "The rounded set as a GeoJSON mapping.")
      .def("__str__", [](const Shape& s) { return io::to_wkt(s.geometry, exact_style()); })
      .def("__repr__", [](const Shape& s) { return describe(s.geometry); });
}

void bind_state(nb::class_<Shape>& type) {
  type.def(
          "to_bytes",
          [](const Shape& s) {
            const std::string bytes = state_of(s);
            return nb::bytes(bytes.data(), bytes.size());
          },
          "Return the geometry exactly, in a versioned form that `from_bytes` reads. Equal "
          "geometries have equal bytes on every machine.")
      .def_static(
          "from_bytes",
          [](const nb::bytes& bytes) {
            return std::make_shared<Shape>(
                shape_from_state({static_cast<const char*>(bytes.data()), bytes.size()}));
          },
          "data"_a, "Return the geometry that `to_bytes` made bytes of.")
      .def(
          "__reduce__",
          [](nb::handle self) {
            return nb::make_tuple(nb::module_::import_("minksum._state").attr("geometry"),
                                  nb::make_tuple(self.attr("to_bytes")()));
          },
          nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"))
      .def(
          "__dask_tokenize__",
          [](nb::handle self) {
            return nb::make_tuple("minksum.Geometry", self.attr("to_bytes")());
          },
          nb::sig("def __dask_tokenize__(self) -> tuple[typing.Any, ...]"));
}

}  // namespace

Geometry set_of(const Shape& shape, const Options& options) {
  return shape.resolved ? shape.geometry : resolve(shape.geometry, options);
}

std::size_t hash_of(const Shape& shape) { return hash_of_vertices(shape.geometry); }

std::string wkb_of(const Shape& shape, const std::string& round, bool include_srid,
                   const Options& options) {
  std::string wkb = io::to_wkb(writable(shape, round, options));
  if (include_srid && shape.srid != 0) {
    // PostGIS's form: bit 0x20000000 of the code says that the number follows the code.
    wkb[4] = static_cast<char>(static_cast<unsigned char>(wkb[4]) | 0x20U);
    std::string srid;
    for (int shift = 0; shift < 32; shift += 8) {
      srid += static_cast<char>(static_cast<std::uint32_t>(shape.srid) >> shift);
    }
    wkb.insert(5, srid);
  }
  return wkb;
}

void bind_geometry(nb::module_& m) {
  nb::class_<Shape> type(m, "Geometry",
                         "A set of points in the plane: areas, polylines and points, with exact "
                         "coordinates. It never changes.");
  type.def(
          "__init__",
          [](Shape* self, nb::handle object, const std::string& z) {
            ShapePtr shape = operand_of(object, {drops_z(z)});
            if (!shape) throw nb::type_error("None is not a geometry");
            new (self) Shape(*shape);
          },
          nb::arg("object"), nb::kw_only(), "z"_a = "error",
          nb::sig("def __init__(self, object: GeometryLike, *, z: str = 'error') -> None"),
          "Make a geometry from whatever the functions of this package take as an operand.")
      .def_prop_ro(
          "is_empty", [](const Shape& s) { return s.geometry.empty(); }, "Whether it is empty.")
      .def_prop_ro(
          "area",
          [](const Shape& s) {
            return computed(s, [&](const Options& options) {
              return approximate_area(set_of(s, options).region);
            });
          },
          "The area as a float. `minksum.area(g, exact=True)` is exact.")
      .def_prop_ro(
          "bounds", [](nb::handle self) { return bounds_of(self, false); },
          nb::sig("def bounds(self) -> tuple[float, float, float, float] | None"),
          "The bounding box (xmin, ymin, xmax, ymax) as floats; None for the empty set. "
          "`minksum.bounds(g, exact=True)` is exact.")
      .def_prop_ro(
          "geom_type", [](const Shape& s) { return geometry_type(s.geometry); },
          "The name of the type in GeoJSON and Shapely.")
      .def_prop_ro(
          "has_thin_parts", [](const Shape& s) { return s.geometry.has_thin_parts(); },
          "Whether there are polylines or points.")
      .def_prop_ro(
          "num_vertices", [](const Shape& s) { return vertex_count(s.geometry); },
          "The number of vertices of all parts.")
      .def_prop_ro(
          "num_polygons", [](const Shape& s) { return s.geometry.region.polygon_count(); },
          "The number of polygons.")
      .def_prop_ro(
          "num_holes", [](const Shape& s) { return s.geometry.region.hole_count(); },
          "The number of holes of all polygons.")
      .def_prop_ro(
          "srid", [](const Shape& s) { return s.srid; },
          "The number of the reference system; 0 if it is unknown.")
      .def(
          "with_srid",
          [](const Shape& s, std::int32_t srid) {
            return std::make_shared<Shape>(Shape{s.geometry, srid});
          },
          "srid"_a, "Return the same geometry with another reference system.")
      .def_prop_ro(
          "coords", [](const Shape& s) { return coordinates(s.geometry); },
          nb::sig("def coords(self) -> numpy.typing.NDArray[numpy.float64]"),
          "The nearest doubles of all vertices, as an array of shape (n, 2).")
      .def(
          "exact_coords", [](const Shape& s) { return exact_coordinates(s.geometry); },
          nb::sig("def exact_coords(self) -> dict[str, list[typing.Any]]"),
          "Return the exact vertices: a dict with lists of 'polygons' (each a list of rings, the "
          "outer one first), 'polylines' and 'points'. Coordinates are int or Fraction.")
      .def_prop_ro(
          "origins", [](const Shape& s) { return origins(s.geometry); },
          nb::sig("def origins(self) -> list[tuple[int, int, int]] | None"),
          "For the edge that starts at each vertex of a sum: the operand that has the edge, the "
          "index of the edge's first vertex, and that of the other operand's vertex. None if it "
          "is not known.")
      .def(
          "__eq__",
          [](const Shape& a, nb::handle other) -> nb::object {
            ShapePtr b;  // stays null for None
            if (!nb::try_cast(other, b, false) || !b) return nb::borrow(Py_NotImplemented);
            return nb::bool_(a.geometry == b->geometry);
          },
          "other"_a.none(), nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__", hash_of)
      .def("__bool__", [](const Shape& s) { return !s.geometry.empty(); });
  bind_conversions(type);
  bind_state(type);
}

}  // namespace minksum::python

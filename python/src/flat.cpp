#include "flat.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "bindings.hpp"
#include "errors.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

using OffsetArray = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
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
std::span<const std::int64_t> checked(const OffsetArray& offsets, std::size_t most, const char* name,
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
    return nb::cast<OffsetArray>(numbers_of(argument, name, "iu", "integers", 1));
  };
  const auto coordinates = nb::cast<Coordinates>(numbers_of(coords, "coords", "fiu", "numbers", 2));
  if (coordinates.shape(1) != 2) {
    throw nb::type_error("coords must be an array of numbers of the shape (n, 2)");
  }
  const OffsetArray rings = offsets_of(ring_offsets, "ring_offsets");
  const OffsetArray polygons = offsets_of(polygon_offsets, "polygon_offsets");
  std::optional<OffsetArray> geometries;
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
  FlatArrays flat = flat_arrays(array);
  return nb::make_tuple(numpy_array(std::move(flat.coordinates), 2),
                        nb::make_tuple(numpy_array(std::move(flat.rings), 1),
                                       numpy_array(std::move(flat.polygons), 1),
                                       numpy_array(std::move(flat.geometries), 1)));
}

}  // namespace

FlatArrays flat_arrays(const ShapeArray& array) {
  FlatArrays flat;
  for (const ShapePtr& item : array.items) {
    if (!item || item->geometry.has_thin_parts()) {
      const std::string message =
          "element " + std::to_string(flat.geometries.size() - 1) +
          (item ? " has polylines or points: these flat arrays hold polygons alone"
                : " is missing: flat arrays have no missing geometries");
      throw nb::value_error(message.c_str());
    }
    const Region& region = item->geometry.region;
    for (const std::size_t polygon : region.polygons()) {
      for (const std::size_t ring : region.rings_of(polygon)) {
        const IndexRange vertices = region.vertices_of(ring);
        const auto append = [&](std::size_t v) {
          flat.coordinates.push_back(region.x(v));
          flat.coordinates.push_back(region.y(v));
        };
        for (const std::size_t v : vertices) append(v);
        if (!vertices.empty()) append(vertices.front());
        flat.rings.push_back(static_cast<std::int64_t>(flat.coordinates.size() / 2));
      }
      flat.polygons.push_back(static_cast<std::int64_t>(flat.rings.size() - 1));
    }
    flat.geometries.push_back(static_cast<std::int64_t>(flat.polygons.size() - 1));
  }
  return flat;
}

void bind_flat(nb::module_& m) {
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
}

}  // namespace minksum::python

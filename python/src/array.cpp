// Binds GeometryArray.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <utility>

#include "bindings.hpp"
#include "call.hpp"
#include "shape.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

nb::object element(const ShapeArray& array, nb::handle key) {
  std::size_t index = 0;
  if (array.shape.size() == 1 && nb::try_cast(key, index, false) && index < array.items.size()) {
    return to_object(array.items[index]);
  }
  // NumPy knows how indices and slices work: it is asked which elements are meant.
  const nb::object numpy = nb::module_::import_("numpy");
  const nb::object places =
      numpy.attr("arange")(array.items.size()).attr("reshape")(nb::tuple(nb::cast(array.shape)));
  const nb::object chosen = places[key];
  if (nb::len(nb::object(chosen.attr("shape"))) == 0) {
    return to_object(array.items[nb::cast<std::size_t>(chosen.attr("item")())]);
  }
  ShapeArray part;
  part.shape = nb::cast<std::vector<std::size_t>>(nb::list(chosen.attr("shape")));
  for (const std::size_t i :
       nb::cast<std::vector<std::size_t>>(chosen.attr("ravel")().attr("tolist")())) {
    part.items.push_back(array.items[i]);
  }
  return to_object(std::move(part));
}

nb::object objects_of(const ShapeArray& array) {
  const nb::object numpy = nb::module_::import_("numpy");
  nb::object flat = numpy.attr("empty")(array.items.size(), "dtype"_a = "O");
  for (std::size_t i = 0; i < array.items.size(); ++i) flat[i] = to_object(array.items[i]);
  return flat.attr("reshape")(nb::tuple(nb::cast(array.shape)));
}

nb::object wkb_array(const ShapeArray& array, const std::string& round, bool include_srid) {
  const nb::object numpy = nb::module_::import_("numpy");
  nb::object flat = numpy.attr("empty")(array.items.size(), "dtype"_a = "O");
  std::vector<std::string> written(array.items.size());
  Call().for_each(array.shape, [&](std::size_t i, const Options& options) {
    if (array.items[i]) written[i] = wkb_of(*array.items[i], round, include_srid, options);
  });
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (array.items[i]) flat[i] = nb::bytes(written[i].data(), written[i].size());
  }
  return flat.attr("reshape")(nb::tuple(nb::cast(array.shape)));
}

ShapeArrayPtr make_array(nb::handle objects, const std::string& z) {
  Operands operands = operands_of(objects, {drops_z(z)});
  if (operands.scalar) operands.array.shape = {1};
  return std::make_shared<ShapeArray>(std::move(operands.array));
}

}  // namespace

void bind_array(nb::module_& m) {
  nb::class_<ShapeArray>(m, "GeometryArray",
                         "An array of geometries in any number of dimensions, which never "
                         "changes. Elements may be missing (None).")
      .def(
          "__init__",
          [](ShapeArray* self, nb::handle objects, const std::string& z) {
            new (self) ShapeArray(*make_array(objects, z));
          },
          "objects"_a, nb::kw_only(), "z"_a = "error",
          nb::sig("def __init__(self, objects: GeometryLike, *, z: str = 'error') -> None"),
          "Make an array from a sequence of operands.")
      .def_prop_ro(
          "shape", [](const ShapeArray& a) { return nb::tuple(nb::cast(a.shape)); },
          nb::sig("def shape(self) -> tuple[int, ...]"), "The length along each dimension.")
      .def_prop_ro(
          "ndim", [](const ShapeArray& a) { return a.shape.size(); }, "The number of dimensions.")
      .def_prop_ro(
          "size", [](const ShapeArray& a) { return a.items.size(); }, "The number of elements.")
      .def("__len__",
           [](const ShapeArray& a) {
             if (a.shape.empty()) throw nb::type_error("an array of no dimension has no length");
             return a.shape.front();
           })
      .def(
          "__arrow_c_array__",
          [](nb::handle self, nb::handle /*requested_schema*/) {
            return nb::module_::import_("minksum._core").attr("_to_arrow")(self, "wkb", "nearest");
          },
          "requested_schema"_a = nb::none(),
          nb::sig("def __arrow_c_array__(self, requested_schema: typing.Any = None) -> "
                  "tuple[typing.Any, typing.Any]"),
          "Return the array as a column of Arrow: WKB of rounded sets, of the type geoarrow.wkb.")
      .def("__getitem__", element, "key"_a,
           nb::sig("def __getitem__(self, key: typing.Any) -> typing.Any"))
      .def(
          "__array__",
          [](const ShapeArray& a, nb::handle /*dtype*/, nb::handle /*copy*/) {
            return objects_of(a);
          },
          "dtype"_a = nb::none(), "copy"_a = nb::none(),
          nb::sig("def __array__(self, dtype: typing.Any = None, copy: typing.Any = None) -> "
                  "numpy.typing.NDArray[numpy.object_]"))
      .def(
          "reshape",
          [](const ShapeArray& a, const std::vector<std::size_t>& shape) {
            std::size_t count = 1;
            for (const std::size_t side : shape) count *= side;
            if (count != a.items.size()) throw nb::value_error("the shape has another size");
            return std::make_shared<ShapeArray>(ShapeArray{a.items, shape});
          },
          "shape"_a, "Return the same elements in another shape.")
      .def("to_wkb", wkb_array, nb::kw_only(), "round"_a = "nearest", "include_srid"_a = false,
           nb::sig("def to_wkb(self, *, round: str = 'nearest', include_srid: bool = False) -> "
                   "numpy.typing.NDArray[numpy.object_]"),
           "Return an array of objects with the WKB of each rounded element.")
      .def(
          "__eq__",
          [](const ShapeArray& a, nb::handle other) -> nb::object {
            ShapeArrayPtr b;  // stays null for None
            if (!nb::try_cast(other, b, false) || !b) return nb::borrow(Py_NotImplemented);
            if (a.shape != b->shape) return nb::bool_(false);
            for (std::size_t i = 0; i < a.items.size(); ++i) {
              const ShapePtr& x = a.items[i];
              const ShapePtr& y = b->items[i];
              if (!x || !y ? x != y : x->geometry != y->geometry) return nb::bool_(false);
            }
            return nb::bool_(true);
          },
          "other"_a.none(), nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const ShapeArray& a) {
             std::size_t hash = a.items.size();
             for (const std::size_t side : a.shape) hash = hash * 1000003U ^ side;
             for (const ShapePtr& x : a.items) hash = hash * 1000003U ^ (x ? hash_of(*x) : 0);
             return hash;
           })
      .def("__repr__",
           [](const ShapeArray& a) {
             std::string text = "<minksum.GeometryArray of shape (";
             for (std::size_t i = 0; i < a.shape.size(); ++i) {
               text += (i == 0 ? "" : ", ") + std::to_string(a.shape[i]);
             }
             return text + (a.shape.size() == 1 ? ",)>" : ")>");
           })
      .def(
          "__reduce__",
          [](nb::handle self) {
            const auto& array = nb::cast<const ShapeArray&>(self);
            nb::list items;
            for (const ShapePtr& item : array.items) items.append(to_object(item));
            return nb::make_tuple(nb::module_::import_("minksum._state").attr("array"),
                                  nb::make_tuple(items, nb::tuple(nb::cast(array.shape))));
          },
          nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]"))
      .def_static(
          "_make",
          [](const std::vector<ShapePtr>& items, const std::vector<std::size_t>& shape) {
            return std::make_shared<ShapeArray>(ShapeArray{items, shape});
          },
          nb::arg("items"), "shape"_a,
          nb::sig("def _make(items: typing.Sequence[Geometry | None], "
                  "shape: typing.Sequence[int]) -> GeometryArray"));
}

}  // namespace minksum::python

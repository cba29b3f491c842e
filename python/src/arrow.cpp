// Binds columns of WKB, as Arrow lays them out: bytes behind each other, and where each begins.
#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "bindings.hpp"
#include "call.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

template <class Number>
using Flat = nb::ndarray<const Number, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

void check(const Flat<std::int64_t>& offsets, std::size_t elements, std::size_t bytes) {
  bool good = offsets.shape(0) == elements + 1 && offsets.data()[0] >= 0;
  std::size_t i = 0;
  for (; good && i < elements; ++i) good = offsets.data()[i] <= offsets.data()[i + 1];
  if (!good || static_cast<std::uint64_t>(offsets.data()[elements]) > bytes) {
    throw Error(ErrorCode::kBadInput,
                "offset " + std::to_string(i) +
                    " of a column: offsets must not decrease or pass the end of the bytes");
  }
}

ShapeArrayPtr from_wkb_column(const Flat<std::uint8_t>& bytes, const Flat<std::int64_t>& offsets,
                              const Flat<bool>& valid, const std::string& z) {
  const bool drop_z = drops_z(z);
  const std::size_t count = valid.shape(0);
  check(offsets, count, bytes.shape(0));
  auto array = std::make_shared<ShapeArray>(
      ShapeArray{std::vector<ShapePtr>(count), std::vector<std::size_t>{count}});
  Call call;
  call.for_each(array->shape, [&](std::size_t i, const Options& /*options*/) {
    if (!valid.data()[i]) return;
    const std::int64_t begin = offsets.data()[i];
    const auto size = static_cast<std::size_t>(offsets.data()[i + 1] - begin);
    array->items[i] = read_wkb({reinterpret_cast<const char*>(bytes.data()) + begin, size}, drop_z);
  });
  return array;
}

template <class Number, class Values>
nb::object owned(Values values) {
  auto* kept = new Values(std::move(values));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<Values*>(p); });
  auto* data = reinterpret_cast<Number*>(kept->data());
  return nb::cast(nb::ndarray<nb::numpy, Number, nb::ndim<1>>(data, {kept->size()}, owner));
}

nb::tuple to_wkb_column(const ShapeArray& array, const std::string& side) {
  std::vector<std::string> each(array.items.size());
  Call call;
  call.for_each({each.size()}, [&](std::size_t i, const Options& options) {
    if (array.items[i]) each[i] = wkb_of(*array.items[i], side, false, options);
  });
  std::string bytes;
  std::vector<std::int64_t> offsets{0};
  for (const std::string& wkb : each) {
    bytes += wkb;
    offsets.push_back(static_cast<std::int64_t>(bytes.size()));
  }
  return nb::make_tuple(owned<std::uint8_t>(std::move(bytes)),
                        owned<std::int64_t>(std::move(offsets)));
}

}  // namespace

void bind_arrow(nb::module_& m) {
  m.def("_from_wkb_column", from_wkb_column, "bytes"_a, "offsets"_a, "valid"_a, "z"_a,
        nb::sig("def _from_wkb_column(bytes: numpy.typing.NDArray[numpy.uint8], "
                "offsets: numpy.typing.NDArray[numpy.int64], "
                "valid: numpy.typing.NDArray[numpy.bool_], z: str) -> GeometryArray"));
  m.def("_to_wkb_column", to_wkb_column, "array"_a, "side"_a,
        nb::sig("def _to_wkb_column(array: GeometryArray, side: str) -> "
                "tuple[numpy.typing.NDArray[numpy.uint8], numpy.typing.NDArray[numpy.int64]]"));
}

}  // namespace minksum::python

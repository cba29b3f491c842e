// Writes columns of geometries by Arrow's C data interface.
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arrow_abi.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "flat.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

/// A column and the columns in it. It lives until the receiver of both structures is done.
struct Column {
  std::string format;
  std::string name;
  std::string metadata;
  std::int64_t length = 0;
  std::int64_t missing = 0;
  std::vector<std::uint8_t> present;  ///< a bit for each element; empty = all are there
  std::vector<std::int32_t> offsets;
  std::vector<std::int64_t> large_offsets;
  std::string bytes;
  std::vector<double> numbers;
  std::shared_ptr<Column> child;

  const void* buffers[3] = {};
  ArrowSchema child_schema{};
  ArrowArray child_array{};
  ArrowSchema* child_schemas[1] = {&child_schema};
  ArrowArray* child_arrays[1] = {&child_array};
};
using ColumnPtr = std::shared_ptr<Column>;

// Both structures own the column, whichever the receiver frees first.
template <class T>
void release(T* structure) {
  for (std::int64_t c = 0; c < structure->n_children; ++c) {
    if (structure->children[c]->release != nullptr) {
      structure->children[c]->release(structure->children[c]);
    }
  }
  structure->release = nullptr;
  delete static_cast<ColumnPtr*>(structure->private_data);
}

void fill(ArrowSchema& schema, const ColumnPtr& column) {
  schema = {};
  schema.format = column->format.c_str();
  schema.name = column->name.c_str();
  schema.metadata = column->metadata.empty() ? nullptr : column->metadata.data();
  schema.flags = 2;  // elements may be missing
  if (column->child) {
    fill(column->child_schema, column->child);
    schema.n_children = 1;
    schema.children = column->child_schemas;
  }
  schema.private_data = new ColumnPtr(column);
  schema.release = release<ArrowSchema>;
}

void fill(ArrowArray& array, const ColumnPtr& column) {
  array = {};
  array.length = column->length;
  array.null_count = column->missing;
  if (!column->present.empty()) column->buffers[array.n_buffers] = column->present.data();
  ++array.n_buffers;
  const auto add = [&](const auto& content) {
    column->buffers[array.n_buffers++] = content.data();
  };
  if (!column->offsets.empty()) add(column->offsets);
  if (!column->large_offsets.empty()) add(column->large_offsets);
  if (column->format == "g") add(column->numbers);
  if (column->format == "z" || column->format == "Z") add(column->bytes);
  array.buffers = column->buffers;
  if (column->child) {
    fill(column->child_array, column->child);
    array.n_children = 1;
    array.children = column->child_arrays;
  }
  array.private_data = new ColumnPtr(column);
  array.release = release<ArrowArray>;
}

template <class T>
nb::capsule capsule_of(const ColumnPtr& column, const char* name) {
  auto* structure = new T();
  fill(*structure, column);
  return {structure, name, [](void* p) noexcept {
            auto* kept = static_cast<T*>(p);
            if (kept->release != nullptr) kept->release(kept);
            delete kept;
          }};
}

/// Returns metadata that names an extension type, as the specification lays it out.
std::string type_name(const std::string& name) {
  std::string bytes;
  const auto put = [&bytes](std::size_t value) {
    const auto number = static_cast<std::int32_t>(value);
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes.append(raw, sizeof number);
  };
  put(2);
  for (const std::string& text : {std::string("ARROW:extension:name"), name,
                                  std::string("ARROW:extension:metadata"), std::string("{}")}) {
    put(text.size());
    bytes += text;
  }
  return bytes;
}

/// Gives a column its offsets, which need 64 bits if the content is long.
void set_offsets(Column& column, const std::vector<std::int64_t>& offsets, const char* small,
                 const char* large) {
  column.length = static_cast<std::int64_t>(offsets.size()) - 1;
  if (offsets.back() > std::numeric_limits<std::int32_t>::max()) {
    column.format = large;
    column.large_offsets = offsets;
  } else {
    column.format = small;
    column.offsets.assign(offsets.begin(), offsets.end());
  }
}

ColumnPtr wkb_column(const ShapeArray& array, const std::string& side) {
  std::vector<std::string> each(array.items.size());
  Call call;
  call.for_each({each.size()}, [&](std::size_t i, const Options& options) {
    if (array.items[i]) each[i] = wkb_of(*array.items[i], side, false, options);
  });
  auto column = std::make_shared<Column>();
  std::vector<std::int64_t> offsets{0};
  column->present.resize((each.size() + 7) / 8);
  for (std::size_t i = 0; i < each.size(); ++i) {
    column->bytes += each[i];
    offsets.push_back(static_cast<std::int64_t>(column->bytes.size()));
    if (array.items[i]) {
      column->present[i / 8] |= static_cast<std::uint8_t>(1U << (i % 8));
    } else {
      ++column->missing;
    }
  }
  if (column->missing == 0) column->present.clear();
  set_offsets(*column, offsets, "z", "Z");
  return column;
}

ColumnPtr list_column(const std::vector<std::int64_t>& offsets, const char* name, ColumnPtr child) {
  auto column = std::make_shared<Column>();
  set_offsets(*column, offsets, "+l", "+L");
  child->name = name;
  column->child = std::move(child);
  return column;
}

ColumnPtr multipolygon_column(const ShapeArray& array) {
  FlatArrays flat = flat_arrays(array);
  auto numbers = std::make_shared<Column>();
  numbers->format = "g";
  numbers->name = "xy";
  numbers->length = static_cast<std::int64_t>(flat.coordinates.size());
  numbers->numbers = std::move(flat.coordinates);
  auto vertices = std::make_shared<Column>();
  vertices->format = "+w:2";
  vertices->length = numbers->length / 2;
  vertices->child = std::move(numbers);
  return list_column(flat.geometries, "polygons",
                     list_column(flat.polygons, "rings",
                                 list_column(flat.rings, "vertices", std::move(vertices))));
}

}  // namespace

void bind_arrow_export(nb::module_& m) {
  m.def(
      "_to_arrow",
      [](const ShapeArray& array, const std::string& encoding, const std::string& side) {
        if (array.shape.size() != 1) {
          throw nb::value_error("a column of Arrow has one dimension");
        }
        const bool wkb = encoding == "wkb";
        if (!wkb && encoding != "multipolygon") {
          throw nb::value_error("encoding must be \"wkb\" or \"multipolygon\"");
        }
        const ColumnPtr column = wkb ? wkb_column(array, side) : multipolygon_column(array);
        column->metadata = type_name("geoarrow." + encoding);
        return nb::make_tuple(capsule_of<ArrowSchema>(column, "arrow_schema"),
                              capsule_of<ArrowArray>(column, "arrow_array"));
      },
      "array"_a, "encoding"_a, "side"_a,
      nb::sig("def _to_arrow(array: GeometryArray, encoding: str, side: str) -> "
              "tuple[typing.Any, typing.Any]"));
}

}  // namespace minksum::python

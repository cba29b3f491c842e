// Reads columns of geometries by Arrow's C data interface.
#include <nanobind/nanobind.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "arrow_abi.hpp"
#include "bindings.hpp"
#include "call.hpp"
#include "errors.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::kBadInput, what); }

bool is_present(const ArrowArray& array, std::int64_t i) {
  if (array.null_count == 0 || array.n_buffers < 1 || array.buffers[0] == nullptr) return true;
  const std::int64_t at = array.offset + i;
  return (static_cast<const unsigned char*>(array.buffers[0])[at / 8] >> (at % 8) & 1) != 0;
}

/// Returns the name of the extension type that a column has, or "".
std::string extension_of(const ArrowSchema& schema) {
  const char* at = schema.metadata;
  if (at == nullptr) return {};
  const auto number = [&at] {
    std::int32_t value = 0;
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
    return value;
  };
  const auto text = [&] {
    const auto size = static_cast<std::size_t>(number());
    at += size;
    return std::string_view(at - size, size);
  };
  for (std::int32_t left = number(); left > 0; --left) {
    const std::string_view key = text();
    const std::string_view value = text();
    if (key == "ARROW:extension:name") return std::string(value);
  }
  return {};
}

/// Says where elements begin and end in what holds their content.
class Offsets {
 public:
  Offsets(const ArrowArray& array, bool large, std::int64_t most)
      : array_(&array), large_(large), most_(most) {}

  [[nodiscard]] std::pair<std::int64_t, std::int64_t> of(std::int64_t i) const {
    const std::int64_t begin = at(i);
    const std::int64_t end = at(i + 1);
    if (begin < 0 || end < begin || end > most_) {
      refuse("offset " + std::to_string(i + 1) + " of a list is " + std::to_string(end) +
             " after " + std::to_string(begin) + ": offsets must not decrease or pass the end");
    }
    return {begin, end};
  }

 private:
  [[nodiscard]] std::int64_t at(std::int64_t i) const {
    const void* offsets = array_->buffers[1];
    const std::int64_t k = array_->offset + i;
    return large_ ? static_cast<const std::int64_t*>(offsets)[k]
                  : std::int64_t{static_cast<const std::int32_t*>(offsets)[k]};
  }

  const ArrowArray* array_;
  bool large_;
  std::int64_t most_;
};

/// The vertices of a column: separated (a struct of x and y) or interleaved (a list of two).
class Vertices {
 public:
  Vertices(const ArrowSchema& schema, const ArrowArray& array) : array_(&array) {
    const std::string_view format = schema.format;
    const bool lists = format == "+w:2" && schema.n_children == 1;
    if (!lists && !(format == "+s" && schema.n_children == 2 &&
                    std::strcmp(schema.children[0]->name, "x") == 0 &&
                    std::strcmp(schema.children[1]->name, "y") == 0)) {
      refuse("the coordinates of a column must be x and y alone");
    }
    for (std::int64_t c = 0; c < schema.n_children; ++c) {
      const ArrowArray& part = *array.children[c];
      if (std::strcmp(schema.children[c]->format, "g") != 0) {
        refuse("the coordinates of a column must be doubles (float64)");
      }
      const std::int64_t needed = (array.offset + array.length) * (lists ? 2 : 1);
      if (part.length < needed) refuse("a column has fewer coordinates than vertices");
      const auto* values = static_cast<const double*>(part.buffers[1]) + part.offset;
      numbers_[c] = values + array.offset * (lists ? 2 : 1);
    }
    if (lists) numbers_[1] = numbers_[0] + 1;
    stride_ = lists ? 2 : 1;
    columns_ = schema.n_children;
  }

  [[nodiscard]] double x(std::int64_t i) const { return numbers_[0][stride_ * i]; }
  [[nodiscard]] double y(std::int64_t i) const { return numbers_[1][stride_ * i]; }
  [[nodiscard]] Point point(std::int64_t i) const { return {check(i), Rational(y(i))}; }
  /// GeoArrow writes the empty point as NaN.
  [[nodiscard]] bool is_empty(std::int64_t i) const { return std::isnan(x(i)) && std::isnan(y(i)); }

  void append_ring(Region& region, std::int64_t begin, std::int64_t end) const {
    region.begin_ring();
    // Rings repeat their first vertex in these columns; a region stores it once.
    if (end - begin > 1 && x(begin) == x(end - 1) && y(begin) == y(end - 1)) --end;
    for (std::int64_t i = begin; i < end; ++i) {
      (void)check(i);
      region.add_vertex(x(i), y(i));
    }
  }

 private:
  double check(std::int64_t i) const {
    bool present = is_present(*array_, i);
    for (std::int64_t c = 0; c < columns_; ++c) {
      const ArrowArray& part = *array_->children[c];
      const std::int64_t first = (array_->offset + i) * stride_;
      present = present && is_present(part, first) && is_present(part, first + stride_ - 1);
    }
    if (!present) refuse("vertex " + std::to_string(i) + " of a column is missing");
    return x(i);
  }

  const ArrowArray* array_;
  const double* numbers_[2] = {};
  std::int64_t stride_ = 1;
  std::int64_t columns_ = 2;
};

/// Reads elements of one array of Arrow.
class Reader {
 public:
  Reader(const ArrowSchema& schema, const ArrowArray& array, bool drop_z)
      : array_(&array), drop_z_(drop_z) {
    const std::string_view format = schema.format;
    kind_ = extension_of(schema);
    if (kind_.starts_with("geoarrow.")) kind_.erase(0, 9);
    if (schema.dictionary != nullptr) refuse("a column with a dictionary holds no geometries");
    if (format == "z" || format == "Z") {
      levels_.emplace_back(array, format == "Z", INT64_MAX);
      kind_ = "wkb";
      return;
    }
    if (format == "vz") {
      kind_ = "views";
      return;
    }
    const ArrowSchema* type = &schema;
    const ArrowArray* values = &array;
    for (; std::strcmp(type->format, "+l") == 0 || std::strcmp(type->format, "+L") == 0;
         type = type->children[0], values = values->children[0]) {
      levels_.emplace_back(*values, type->format[1] == 'L', values->children[0]->length);
      arrays_.push_back(values);
    }
    const std::size_t depth = levels_.size();
    if (kind_.empty() || kind_ == "polygon" || kind_ == "multipolygon") {
      if (depth == 2 || depth == 3) kind_ = depth == 2 ? "polygon" : "multipolygon";
    }
    const bool fits = kind_ == "point"                                 ? depth == 0
                      : kind_ == "linestring" || kind_ == "multipoint" ? depth == 1
                      : kind_ == "polygon" || kind_ == "multilinestring"
                          ? depth == 2
                          : kind_ == "multipolygon" && depth == 3;
    if (!fits) {
      refuse("an Arrow column of the format '" + std::string(format) +
             "' holds no WKB and no geometries of GeoArrow");
    }
    vertices_.emplace(*type, *values);
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(array_->length); }

  [[nodiscard]] ShapePtr read(std::size_t index) const {
    const auto i = static_cast<std::int64_t>(index);
    if (!is_present(*array_, i)) return nullptr;
    if (kind_ == "wkb") {
      const auto [begin, end] = levels_[0].of(i);
      const char* bytes = static_cast<const char*>(array_->buffers[2]);
      return read_wkb(
          begin == end ? std::string_view() : std::string_view(bytes + begin, end - begin),
          drop_z_);
    }
    if (kind_ == "views") return read_wkb(view(i), drop_z_);
    auto shape = std::make_shared<Shape>();
    Geometry& geometry = shape->geometry;
    if (kind_ == "multipolygon") {
      each(0, i, [&](std::int64_t p) { polygon(geometry.region, 1, p); });
    } else if (kind_ == "polygon") {
      polygon(geometry.region, 0, i);
    } else if (kind_ == "multilinestring") {
      each(0, i, [&](std::int64_t l) { polyline(geometry, 1, l); });
    } else if (kind_ == "linestring") {
      polyline(geometry, 0, i);
    } else if (kind_ == "multipoint") {
      each(0, i, [&](std::int64_t p) { geometry.points.push_back(vertices_->point(p)); });
    } else if (!vertices_->is_empty(i)) {
      geometry.points.push_back(vertices_->point(i));
    }
    return shape;
  }

 private:
  /// Returns the bytes of an element of the layout of views, as the specification has them: a
  /// length, and up to 12 bytes, or a buffer and the place in it.
  [[nodiscard]] std::string_view view(std::int64_t i) const {
    const char* at = static_cast<const char*>(array_->buffers[1]) + 16 * (array_->offset + i);
    std::int32_t words[4];
    std::memcpy(words, at, sizeof words);
    const auto length = static_cast<std::size_t>(words[0]);
    if (words[0] < 0) refuse("a view of a column has a negative length");
    if (words[0] <= 12) return {at + 4, length};
    // The lengths of the buffers lie in the last buffer.
    const auto* lengths = static_cast<const std::int64_t*>(array_->buffers[array_->n_buffers - 1]);
    if (words[2] < 0 || words[2] >= array_->n_buffers - 3 || words[3] < 0 ||
        std::int64_t{words[3]} + words[0] > lengths[words[2]]) {
      refuse("a view of a column passes the end of its buffer");
    }
    return {static_cast<const char*>(array_->buffers[2 + words[2]]) + words[3], length};
  }
  template <class Visit>
  void each(std::size_t level, std::int64_t i, const Visit& visit) const {
    if (!is_present(*arrays_[level], i)) return;
    const auto [begin, end] = levels_[level].of(i);
    for (std::int64_t k = begin; k < end; ++k) visit(k);
  }
  void polygon(Region& region, std::size_t level, std::int64_t i) const {
    bool begun = false;
    each(level, i, [&](std::int64_t ring) {
      if (!begun) region.begin_polygon();
      begun = true;
      const auto [begin, end] = levels_[level + 1].of(ring);
      vertices_->append_ring(region, begin, end);
    });
  }
  void polyline(Geometry& geometry, std::size_t level, std::int64_t i) const {
    Polyline line;
    each(level, i, [&](std::int64_t v) { line.push_back(vertices_->point(v)); });
    if (!line.empty()) geometry.polylines.push_back(std::move(line));
  }

  const ArrowArray* array_;
  bool drop_z_;
  std::string kind_;
  std::vector<Offsets> levels_;
  std::vector<const ArrowArray*> arrays_;
  std::optional<Vertices> vertices_;
};

/// Frees a structure that this module received.
template <class T>
struct Received {
  T value{};
  ~Received() {
    if (value.release != nullptr) value.release(&value);
  }
};

template <class T>
T* pointer(nb::handle capsule, const char* name) {
  void* found = PyCapsule_GetPointer(capsule.ptr(), name);
  if (found == nullptr) throw nb::python_error();
  return static_cast<T*>(found);
}

void append(ShapeArray& all, const ArrowSchema& schema, const ArrowArray& array, Reading how) {
  const Reader reader(schema, array, how.drop_z);
  const std::size_t before = all.items.size();
  all.items.resize(before + reader.size());
  Call call;
  if (how.forgive) call.forgive();
  try {
    call.for_each({reader.size()}, [&](std::size_t i, const Options& /*options*/) {
      all.items[before + i] = reader.read(i);
    });
  } catch (ElementError& error) {
    error.index.front() += before;
    throw;
  }
}

void append_stream(ShapeArray& all, ArrowArrayStream& stream, Reading how) {
  const auto check = [&stream](int code) {
    if (code == 0) return;
    const char* message = stream.get_last_error(&stream);
    refuse(std::string("a stream of Arrow failed: ") +
           (message != nullptr ? message : std::to_string(code)));
  };
  Received<ArrowSchema> schema;
  check(stream.get_schema(&stream, &schema.value));
  for (;;) {
    Received<ArrowArray> array;
    check(stream.get_next(&stream, &array.value));
    if (array.value.release == nullptr) return;
    append(all, schema.value, array.value, how);
  }
}

}  // namespace

bool is_arrow(nb::handle object) {
  return nb::hasattr(object, "__arrow_c_array__") || nb::hasattr(object, "__arrow_c_stream__");
}

ShapeArray shapes_of_arrow(nb::handle object, Reading reading) {
  ShapeArray all;
  if (nb::hasattr(object, "__arrow_c_array__")) {
    const auto pair = nb::cast<nb::tuple>(object.attr("__arrow_c_array__")());
    append(all, *pointer<ArrowSchema>(pair[0], "arrow_schema"),
           *pointer<ArrowArray>(pair[1], "arrow_array"), reading);
  } else {
    const nb::object stream = object.attr("__arrow_c_stream__")();
    append_stream(all, *pointer<ArrowArrayStream>(stream, "arrow_array_stream"), reading);
  }
  all.shape = {all.items.size()};
  return all;
}

void bind_arrow(nb::module_& m) {
  m.def(
      "_from_arrow",
      [](nb::handle column, const std::string& z, const std::string& on_error) {
        if (!is_arrow(column)) {
          const std::string message = "expected an Arrow array, found " +
                                      nb::cast<std::string>(column.type().attr("__name__"));
          throw nb::type_error(message.c_str());
        }
        return std::make_shared<ShapeArray>(
            shapes_of_arrow(column, {drops_z(z), forgives(on_error)}));
      },
      "column"_a.none(), "z"_a, "on_error"_a,
      nb::sig("def _from_arrow(column: typing.Any, z: str, on_error: str) -> GeometryArray"));
  bind_arrow_export(m);
}

}  // namespace minksum::python

#include "elementwise.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <deque>
#include <string>

namespace nb = nanobind;
using namespace nb::literals;

namespace minksum::python {
namespace {

// Below this count of pairs of edges an operation takes some microseconds, and releasing the lock
// would take as long as other threads could win by it.
constexpr std::size_t kSmall = 1000;

std::size_t side_of_shape(const std::vector<std::size_t>& shape, std::size_t from_last) {
  return from_last < shape.size() ? shape[shape.size() - 1 - from_last] : 1;
}

std::vector<std::size_t> indices(const std::vector<std::size_t>& whole,
                                 const std::vector<std::size_t>& part) {
  std::size_t count = 1;
  for (const std::size_t side : whole) count *= side;
  std::vector<std::size_t> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    std::size_t stride = 1;
    for (std::size_t d = 0; d < whole.size(); ++d) {
      const std::size_t place = rest % side_of_shape(whole, d);
      rest /= side_of_shape(whole, d);
      const std::size_t side = side_of_shape(part, d);
      if (side != 1) result[i] += place * stride;
      stride *= side;
    }
  }
  return result;
}

}  // namespace

Pairs::Pairs(const Operands& a, const Operands& b) {
  const std::size_t dimensions = std::max(a.array.shape.size(), b.array.shape.size());
  shape_.resize(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d) {
    const std::size_t x = side_of_shape(a.array.shape, d);
    const std::size_t y = side_of_shape(b.array.shape, d);
    if (x != y && x != 1 && y != 1) {
      const std::string message = "arrays of " + std::to_string(x) + " and " + std::to_string(y) +
                                  " elements along one dimension cannot be combined";
      throw nb::value_error(message.c_str());
    }
    shape_[dimensions - 1 - d] = x == 1 ? y : x;
  }
  first_ = indices(shape_, a.array.shape);
  second_ = indices(shape_, b.array.shape);
}

std::int32_t common_srid(const Shape& a, const Shape& b) {
  if (a.srid != 0 && b.srid != 0 && a.srid != b.srid) {
    throw Error(ErrorCode::kBadInput, "the operands have two reference systems, " +
                                          std::to_string(a.srid) + " and " +
                                          std::to_string(b.srid));
  }
  return a.srid != 0 ? a.srid : b.srid;
}

bool is_small(const Geometry& a, const Geometry& b) {
  return !a.has_thin_parts() && !b.has_thin_parts() &&
         (a.region.vertex_count() + 1) * (b.region.vertex_count() + 1) < kSmall;
}

bool is_small(const Geometry& a) { return !a.has_thin_parts() && a.region.vertex_count() < 32; }

nb::object apply(Call& call, nb::handle a, const UnaryOperation& operation) {
  const Argument argument(a, -1, call.forgives());
  if (argument.scalar()) {
    const Shape* x = argument.shape();
    if (x == nullptr) return nb::none();
    Shape result{{}, x->srid, {}, true};
    try {
      call.run(is_small(x->geometry),
               [&] { result.geometry = operation(x->geometry, call.options()); });
    } catch (const Error&) {
      if (!call.forgives() || !is_bad_element()) throw;
      return nb::none();
    }
    return to_object(std::move(result));
  }
  const Operands& operands = argument.array();
  ShapeArray results{std::vector<ShapePtr>(operands.array.items.size()), operands.array.shape};
  call.for_each(operands.array.shape, [&](std::size_t i, const Options& options) {
    const ShapePtr& x = operands.array.items[i];
    if (!x) return;
    results.items[i] =
        std::make_shared<Shape>(Shape{operation(x->geometry, options), x->srid, {}, true});
  });
  return to_object(std::move(results));
}

nb::object apply(Call& call, nb::handle a, nb::handle b, const BinaryOperation& operation) {
  return apply_shapes(call, a, b, [&](const Shape& x, const Shape& y, const Options& options) {
    return operation(x.geometry, y.geometry, options);
  });
}

nb::object apply_shapes(Call& call, nb::handle a, nb::handle b, const ShapeOperation& operation) {
  const Argument left(a, 0, call.forgives());
  const Argument right(b, 1, call.forgives());
  if (left.scalar() && right.scalar()) {
    const Shape* x = left.shape();
    const Shape* y = right.shape();
    if (x == nullptr || y == nullptr) return nb::none();
    Shape result;
    result.resolved = true;
    try {
      result.srid = common_srid(*x, *y);
      call.run(is_small(x->geometry, y->geometry),
               [&] { result.geometry = operation(*x, *y, call.options()); });
    } catch (const Error&) {
      if (!call.forgives() || !is_bad_element()) throw;
      return nb::none();
    }
    return to_object(std::move(result));
  }
  const Operands& first = left.array();
  const Operands& second = right.array();
  const Pairs pairs(first, second);
  ShapeArray results{std::vector<ShapePtr>(pairs.size()), pairs.shape()};
  for_each_pair(call, first, second, pairs,
                [&](std::size_t i, const Shape& x, const Shape& y, const Options& options) {
                  auto result = std::make_shared<Shape>();
                  result->resolved = true;
                  result->srid = common_srid(x, y);
                  result->geometry = operation(x, y, options);
                  results.items[i] = std::move(result);
                });
  return to_object(std::move(results));
}

void def_operator(nb::module_& m, const char* name, const ShapeOperation& operation) {
  for (const char* type : {"Geometry", "GeometryArray"}) {
    static std::deque<std::string> kept;
    const std::string& text =
        kept.emplace_back(std::string("def ") + name + "(self, other: GeometryLike) -> " +
                          "Geometry | GeometryArray | None");
    nb::cpp_function_def(
        [operation](nb::handle a, nb::handle b) -> nb::object {
          if (!nb::isinstance<Shape>(b) && !nb::isinstance<ShapeArray>(b)) {
            return nb::borrow(Py_NotImplemented);
          }
          Call call;
          return apply_shapes(call, a, b, operation);
        },
        nb::scope(m.attr(type)), nb::name(name), nb::is_method(), nb::is_operator(),
        nb::arg("other"), nb::sig(text.c_str()));
  }
}

void def_operator(nb::module_& m, const char* name, const BinaryOperation& operation) {
  def_operator(m, name, [operation](const Shape& a, const Shape& b, const Options& options) {
    return operation(a.geometry, b.geometry, options);
  });
}

nb::object nested(const std::vector<nb::object>& values, const std::vector<std::size_t>& shape,
                  bool scalar) {
  if (scalar) return values.front();
  const nb::object numpy = nb::module_::import_("numpy");
  nb::object flat = numpy.attr("empty")(values.size(), "dtype"_a = "O");
  for (std::size_t i = 0; i < values.size(); ++i) flat[i] = values[i];
  return flat.attr("reshape")(nb::tuple(nb::cast(shape)));
}

}  // namespace minksum::python

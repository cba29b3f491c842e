// Declares how operations run over single geometries and over arrays.
#pragma once

#include <functional>
#include <utility>

#include "call.hpp"
#include "shape.hpp"

namespace minksum::python {

using ShapeOperation = std::function<Geometry(const Shape&, const Shape&, const Options&)>;
using UnaryOperation = std::function<Geometry(const Geometry&, const Options&)>;
using BinaryOperation = std::function<Geometry(const Geometry&, const Geometry&, const Options&)>;

/// Says which elements of two operands meet, as NumPy broadcasts arrays.
class Pairs {
 public:
  /// Throws ValueError if the shapes do not fit together.
  Pairs(const Operands& a, const Operands& b);
  [[nodiscard]] const std::vector<std::size_t>& shape() const { return shape_; }
  [[nodiscard]] std::size_t size() const { return first_.size(); }
  [[nodiscard]] std::size_t first(std::size_t i) const { return first_[i]; }
  [[nodiscard]] std::size_t second(std::size_t i) const { return second_[i]; }

 private:
  std::vector<std::size_t> shape_;
  std::vector<std::size_t> first_;
  std::vector<std::size_t> second_;
};

/// Returns the reference system of a result. Throws Error(kBadInput) for two that differ.
[[nodiscard]] std::int32_t common_srid(const Shape& a, const Shape& b);

/// Calls `visit(i, a, b, options)` for each pair of elements of which none is missing.
template <class Visit>
void for_each_pair(Call& call, const Operands& a, const Operands& b, const Pairs& pairs,
                   const Visit& visit) {
  call.for_each(pairs.shape(), [&](std::size_t i, const Options& options) {
    const ShapePtr& x = a.array.items[pairs.first(i)];
    const ShapePtr& y = b.array.items[pairs.second(i)];
    if (x && y) visit(i, *x, *y, options);
  });
}

/// Tells whether an operation takes so little time that the interpreter's lock is not released.
[[nodiscard]] bool is_small(const Geometry& a, const Geometry& b);
[[nodiscard]] bool is_small(const Geometry& a);

[[nodiscard]] nanobind::object apply(Call& call, nanobind::handle a,
                                     const UnaryOperation& operation);
[[nodiscard]] nanobind::object apply(Call& call, nanobind::handle a, nanobind::handle b,
                                     const BinaryOperation& operation);
/// Returns the same of an operation that keeps something with its operands.
[[nodiscard]] nanobind::object apply_shapes(Call& call, nanobind::handle a, nanobind::handle b,
                                            const ShapeOperation& operation);

/// Adds an operator between geometries and arrays to both classes.
void def_operator(nanobind::module_& m, const char* name, const ShapeOperation& operation);
void def_operator(nanobind::module_& m, const char* name, const BinaryOperation& operation);

/// Returns an array of objects, nested as the array's shape tells, or the only element of a single
/// operand.
[[nodiscard]] nanobind::object nested(const std::vector<nanobind::object>& values,
                                      const std::vector<std::size_t>& shape, bool scalar);

}  // namespace minksum::python

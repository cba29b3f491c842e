// Declares what operands and results are in Python: a geometry, or an array of geometries.
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
#include <memory>
#include <minksum/minksum.hpp>
#include <string>
#include <vector>

#include "prepared.hpp"

namespace minksum::python {

/// How operands are read.
struct Reading {
  bool drop_z = false;   ///< whether what is beyond x and y is dropped, instead of refused
  bool forgive = false;  ///< whether elements of arrays that are bad input become missing
};

/// A geometry with the number of its reference system. It never changes once Python has it.
struct Shape {
  Geometry geometry;
  std::int32_t srid = 0;       ///< 0 = unknown
  PreparedSlot prepared = {};  ///< for sums with others
  bool resolved = false;       ///< whether an operation of this package made it
};
/// Null stands for a missing geometry, which is None in Python.
using ShapePtr = std::shared_ptr<Shape>;
/// Equal geometries have equal hashes.
[[nodiscard]] std::size_t hash_of(const Shape& shape);

/// Geometries in n dimensions, the last one running fastest.
struct ShapeArray {
  std::vector<ShapePtr> items;
  std::vector<std::size_t> shape;
};
using ShapeArrayPtr = std::shared_ptr<ShapeArray>;

/// An operand of a call: one geometry, or an array of them.
struct Operands {
  ShapeArray array;
  bool scalar = false;  ///< whether there is a single one, and `array.shape` is empty
};

/// Says what becomes of coordinates beyond x and y.
[[nodiscard]] bool drops_z(const std::string& z);

/// Returns the geometry or the geometries that a Python object stands for. docs/python.md lists
/// what objects these are. Throws TypeError for any other object, and Error as the readers do.
[[nodiscard]] Operands operands_of(nanobind::handle object, Reading reading = {});
/// Returns the same for a single geometry. Throws TypeError for an array.
[[nodiscard]] ShapePtr operand_of(nanobind::handle object, Reading reading = {});

/// An operand that is not copied if it is a `Geometry`, which the caller's object keeps alive.
class Argument {
 public:
  /// Errors name the operand, which is counted from 0; -1 = there is only one.
  explicit Argument(nanobind::handle object, int operand = -1, bool forgive = false);
  [[nodiscard]] bool scalar() const { return shape_ != nullptr || operands_.scalar; }
  /// Returns a single geometry; null if it is missing.
  [[nodiscard]] const Shape* shape() const {
    return shape_ != nullptr ? shape_ : operands_.array.items.front().get();
  }
  [[nodiscard]] const Operands& array() const;

 private:
  nanobind::handle object_;
  const Shape* shape_ = nullptr;
  mutable Operands operands_;
};

/// Returns the geometry of a GeoJSON object, which is a mapping of Python. Floats are exactly
/// themselves.
[[nodiscard]] ShapePtr shape_of_mapping(nanobind::handle mapping, bool drop_z);

/// Reads WKB or EWKB.
[[nodiscard]] ShapePtr read_wkb(std::string_view bytes, bool drop_z);
/// Reads a text or bytes in a format of the library.
[[nodiscard]] ShapePtr read_shape(std::string_view text, bool drop_z);

/// Returns the set that a geometry means: what its rings enclose, each point once.
[[nodiscard]] Geometry set_of(const Shape& shape, const Options& options);

/// Returns (xmin, ymin, xmax, ymax) as floats or exactly, and None for the empty set. For an array,
/// returns an array of these.
[[nodiscard]] nanobind::object bounds_of(nanobind::handle a, bool exact);

/// Returns the little-endian WKB of a geometry that is rounded to a side, and so stays valid.
[[nodiscard]] std::string wkb_of(const Shape& shape, const std::string& round, bool include_srid,
                                 const Options& options);

/// Tells whether an object is a column of Arrow.
[[nodiscard]] bool is_arrow(nanobind::handle object);
/// Reads a column of WKB or GeoArrow.
[[nodiscard]] ShapeArray shapes_of_arrow(nanobind::handle object, Reading reading);

/// Returns a single geometry or an array as an object of Python; null as None.
[[nodiscard]] nanobind::object to_object(const ShapePtr& shape);
[[nodiscard]] nanobind::object to_object(Shape shape);
[[nodiscard]] nanobind::object to_object(ShapeArray array);

}  // namespace minksum::python

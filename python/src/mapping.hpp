// Declares how sequences and mappings of Python become geometries.
#pragma once

#include <nanobind/nanobind.h>

#include "shape.hpp"

namespace minksum::python {

/// Tells whether an object is a list or a tuple.
[[nodiscard]] bool is_sequence(nanobind::handle object);
/// Tells whether an object is a pair of numbers, perhaps with more behind them.
[[nodiscard]] bool is_point(nanobind::handle object);
/// Returns the polygon with one ring, a sequence of pairs of numbers.
[[nodiscard]] ShapePtr shape_of_ring(nanobind::handle ring, bool drop_z);

}  // namespace minksum::python

// Declares flat arrays of polygons, without an object for each.
#pragma once

#include <cstdint>
#include <vector>

#include "shape.hpp"

namespace minksum::python {

/// Multipolygons, as `shapely.to_ragged_array` lays them out: pairs of doubles, and where rings,
/// polygons and geometries begin. Rings repeat their first vertex.
struct FlatArrays {
  std::vector<double> coordinates;
  std::vector<std::int64_t> rings{0};
  std::vector<std::int64_t> polygons{0};
  std::vector<std::int64_t> geometries{0};
};

/// Throws ValueError for an element that is missing, or has polylines or points.
[[nodiscard]] FlatArrays flat_arrays(const ShapeArray& array);

}  // namespace minksum::python

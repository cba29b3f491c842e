// Converts to GEOS and back. Only files that are compiled where GEOS is available may include this.
#pragma once

#include <geos_c.h>

#include <memory>
#include <type_traits>

#include "minksum/geometry.hpp"

namespace minksum::test {

struct GeosContextDeleter {
  void operator()(GEOSContextHandle_t context) const { GEOS_finish_r(context); }
};
using GeosContext = std::unique_ptr<std::remove_pointer_t<GEOSContextHandle_t>, GeosContextDeleter>;

struct GeosGeometryDeleter {
  GEOSContextHandle_t context;
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
};
using GeosGeometry = std::unique_ptr<GEOSGeometry, GeosGeometryDeleter>;

/// Returns a collection of a multipolygon and all thin parts, in doubles; null if GEOS refuses it.
[[nodiscard]] GeosGeometry to_geos(GEOSContextHandle_t context, const Geometry& geometry);

/// Returns the polygons of a geometry that GEOS made.
[[nodiscard]] Region from_geos(GEOSContextHandle_t context, const GEOSGeometry* geometry);

}  // namespace minksum::test

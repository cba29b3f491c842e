#include "support/geos_validity.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

#ifdef MINKSUM_TEST_GEOS
#include <geos_c.h>
#endif

namespace minksum::test {

#ifdef MINKSUM_TEST_GEOS
namespace {

struct ContextDeleter {
  void operator()(GEOSContextHandle_t context) const { GEOS_finish_r(context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<GEOSContextHandle_t>, ContextDeleter>;

GEOSGeometry* make_ring(GEOSContextHandle_t context, const Region& region, std::size_t ring) {
  const IndexRange vertices = region.vertices_of(ring);
  const auto size = static_cast<unsigned>(vertices.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(context, size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) {
    const std::size_t v = vertices.front() + (i == size ? 0 : i);
    GEOSCoordSeq_setXY_r(context, points, i, region.x(v), region.y(v));
  }
  return GEOSGeom_createLinearRing_r(context, points);
}

GEOSGeometry* make_polygons(GEOSContextHandle_t context, const Region& region) {
  std::vector<GEOSGeometry*> polygons;
  for (const std::size_t polygon : region.polygons()) {
    std::vector<GEOSGeometry*> rings;
    for (const std::size_t ring : region.rings_of(polygon)) {
      rings.push_back(make_ring(context, region, ring));
    }
    polygons.push_back(GEOSGeom_createPolygon_r(context, rings.front(), rings.data() + 1,
                                                static_cast<unsigned>(rings.size() - 1)));
  }
  return GEOSGeom_createCollection_r(context, GEOS_MULTIPOLYGON, polygons.data(),
                                     static_cast<unsigned>(polygons.size()));
}

}  // namespace

bool geos_available() { return true; }

std::string geos_fault(const Region& region) {
  if (region.empty()) return {};
  const Context context(GEOS_init_r());
  GEOSGeometry* geometry = make_polygons(context.get(), region);
  if (geometry == nullptr) return "GEOS takes no such region";
  std::string fault;
  if (GEOSisValid_r(context.get(), geometry) != 1) {
    char* reason = GEOSisValidReason_r(context.get(), geometry);
    fault = reason != nullptr ? reason : "GEOS does not say why";
    GEOSFree_r(context.get(), reason);
  }
  GEOSGeom_destroy_r(context.get(), geometry);
  return fault;
}
#else
bool geos_available() { return false; }
std::string geos_fault(const Region&) { return {}; }
#endif

}  // namespace minksum::test

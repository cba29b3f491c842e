#include "support/geos_validity.hpp"

#ifdef MINKSUM_TEST_GEOS
#include "support/geos_geometry.hpp"
#endif

namespace minksum::test {

#ifdef MINKSUM_TEST_GEOS
bool geos_available() { return true; }

std::string geos_fault(const Region& region) {
  if (region.empty()) return {};
  const GeosContext context(GEOS_init_r());
  const GeosGeometry geometry = to_geos(context.get(), {region, {}, {}});
  if (geometry == nullptr) return "GEOS takes no such region";
  std::string fault;
  if (GEOSisValid_r(context.get(), geometry.get()) != 1) {
    char* reason = GEOSisValidReason_r(context.get(), geometry.get());
    fault = reason != nullptr ? reason : "GEOS does not say why";
    GEOSFree_r(context.get(), reason);
  }
  return fault;
}
#else
bool geos_available() { return false; }
std::string geos_fault(const Region&) { return {}; }
#endif

}  // namespace minksum::test

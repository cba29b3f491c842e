// Asks GEOS whether a region is valid, where GEOS is available.
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::test {

[[nodiscard]] bool geos_available();
/// Returns why GEOS finds a region of doubles not valid; empty if it is valid, or without GEOS.
[[nodiscard]] std::string geos_fault(const Region& region);

}  // namespace minksum::test

// GEOS's opinion on whether a region is valid, where GEOS is there.
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::test {

[[nodiscard]] bool geos_available();
/// Why GEOS thinks that a region of doubles is not valid; empty if it is, or without GEOS.
[[nodiscard]] std::string geos_fault(const Region& region);

}  // namespace minksum::test

// Faults of a region, told.
#pragma once

#include <string>

#include "minksum/validity.hpp"
#include "output/json.hpp"

namespace minksum::cli {

/// "polygon 1, ring 1, vertex 3: edges cross at (1, 2)".
[[nodiscard]] std::string described(const Fault& fault);
/// With the keys polygon, ring, vertex (all from 1, as far as they are known), meets (the same of
/// what is met there), at (exactly, as texts), near (in doubles; null beyond them) and message.
[[nodiscard]] Json fault_json(const Fault& fault);

}  // namespace minksum::cli

// Describes the faults of a region as text and as JSON.
#pragma once

#include <string>

#include "minksum/validity.hpp"
#include "output/json.hpp"

namespace minksum::cli {

/// Returns a text such as "polygon 1, ring 1, vertex 3: edges cross at (1, 2)".
[[nodiscard]] std::string described(const Fault& fault);
/// Returns an object with the keys polygon, ring, vertex, meets, at, near and message. The first
/// three count from 1 and may be missing; `meets` has the same keys for what is met there. `at` has
/// exact texts, and `near` doubles, or null beyond their range.
[[nodiscard]] Json fault_json(const Fault& fault);

}  // namespace minksum::cli

// Is a region valid, is it canonical: decided exactly, by testing every edge against every edge.
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::reference {

/// Why `region` is no valid operand (see minksum::validate); empty if it is.
[[nodiscard]] std::string validity_fault(const Region& region);

/// Why `region` is no canonical result (see minksum::Region); empty if it is. Slow for more than
/// some thousand vertices.
[[nodiscard]] std::string canonical_fault(const Region& region);

}  // namespace minksum::reference

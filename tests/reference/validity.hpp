// Decides exactly whether a region is valid or canonical, by testing every edge against every edge.
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::reference {

/// Returns why `region` is not a valid operand (see minksum::validate); empty if it is one.
[[nodiscard]] std::string validity_fault(const Region& region);

/// Returns why `region` is not a canonical result (see minksum::Region); empty if it is one. Slow
/// for more than some thousand vertices.
[[nodiscard]] std::string canonical_fault(const Region& region);

}  // namespace minksum::reference

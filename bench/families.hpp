// Makes families of operands of any size from fixed seeds, the same on every machine.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "minksum/region.hpp"

namespace minksum::bench {

using Operands = std::pair<Region, Region>;

struct Family {
  std::string name;         ///< such as "spiky stars"
  std::string description;  ///< what P and Q are, for the report
  std::size_t first_size;   ///< about the vertices of the smallest P; sizes double
  Operands (*make)(std::size_t vertices);
};

[[nodiscard]] const std::vector<Family>& families();

/// Returns a regular polygon on a circle, whose corners are decimals of six digits.
[[nodiscard]] Region regular_polygon(std::size_t corners, double radius);
/// Returns −P exactly.
[[nodiscard]] Region negated(const Region& region);

}  // namespace minksum::bench

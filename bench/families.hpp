// Families of operands of any size, from fixed seeds: the same on every machine.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "minksum/region.hpp"

namespace minksum::bench {

using Operands = std::pair<Region, Region>;

struct Family {
  std::string name;         ///< "spiky stars"
  std::string description;  ///< what P and Q are, for the report
  std::size_t first_size;   ///< vertices of P, about, of the smallest member; then doubling
  Operands (*make)(std::size_t vertices);
};

[[nodiscard]] const std::vector<Family>& families();

/// A regular polygon on a circle, its corners decimals of six digits.
[[nodiscard]] Region regular_polygon(std::size_t corners, double radius);
/// −P, exactly.
[[nodiscard]] Region negated(const Region& region);

}  // namespace minksum::bench

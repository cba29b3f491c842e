// How long it takes merely to list the reduced convolution: what any method must pay that looks at
// each of its segments.
#pragma once

#include <cstddef>

#include "minksum/region.hpp"

namespace minksum::bench {

struct Listing {
  std::size_t segments = 0;
  double seconds = 0;  ///< median
};

/// Sorts the edges of both operands by direction and writes down, for every convex vertex, its run
/// of compatible edges of the other operand, moved: two end points each, 32-bit integers, 16 bytes a
/// segment, into memory that was used before. Plain code for this purpose, on operands rounded to
/// 29 bits, in the fastest arithmetic there is; holes too small for the other operand are left out.
[[nodiscard]] Listing list_convolution(const Region& p, const Region& q);

}  // namespace minksum::bench

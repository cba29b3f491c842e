// How long it takes merely to list the reduced convolution: what any method must pay that looks at
// each of its segments.
#pragma once

#include <cstddef>

#include "minksum/region.hpp"

namespace minksum::bench {

struct Listing {
  std::size_t segments = 0;
  double seconds = 0;  ///< median
  /// Whether the operands fit 30-bit integers as they are; otherwise they were rounded to 30 bits,
  /// and the number of segments can be off by a few.
  bool exact = false;
};

/// Writes down the reduced convolution: for every convex vertex its run of compatible edges of the
/// other operand, moved.
///
/// Timed: sorting the edges of both operands by direction, exactly (radix sort by 33 bits, then an
/// exact insertion sort); one merge that tells where each edge's direction lies among the other
/// operand's; and writing two end points a segment, 32-bit integers, 16 bytes, into memory that was
/// used before. Not timed, given as a present: reading the operands, bringing them to integers,
/// repeated and straight vertices, orientation, and the choice of holes that matter (as in the
/// library: by the boxes of the other operand's parts).
[[nodiscard]] Listing list_convolution(const Region& p, const Region& q);

}  // namespace minksum::bench

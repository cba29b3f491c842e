// Measures the time of merely listing the reduced convolution. It is a lower limit for any method
// that looks at each of its segments.
#pragma once

#include <cstddef>

#include "minksum/region.hpp"

namespace minksum::bench {

struct Listing {
  std::size_t segments = 0;
  double seconds = 0;  ///< median of the runs
  /// Whether the operands fit 30-bit integers as they are. Otherwise they were rounded to 30 bits,
  /// and the number of segments can be off by a few.
  bool exact = false;
};

/// Writes down the reduced convolution: for every convex vertex, its run of compatible edges of the
/// other operand, moved by the vertex.
///
/// Three steps are timed. The edges of both operands are sorted by direction, exactly (radix sort
/// by 33 bits, then an exact insertion sort). One merge finds where each edge's direction lies
/// among those of the other operand. Two end points a segment (32-bit integers, 16 bytes) are
/// written into memory that was used before. Other steps are not timed: reading the operands,
/// bringing them to integers, repeated and straight vertices, orientation, and the choice of holes
/// that matter. That choice goes by the boxes of the other operand's parts, as in the library.
[[nodiscard]] Listing list_convolution(const Region& p, const Region& q);

}  // namespace minksum::bench

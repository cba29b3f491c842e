// Measures of a region.
#pragma once

#include <optional>

#include "minksum/export.h"
#include "minksum/options.hpp"
#include "minksum/region.hpp"

namespace minksum {

/// An axis-parallel box with exact sides.
struct Box {
  Point min;  ///< the lower left corner
  Point max;  ///< the upper right corner
};

// Options: `cancel` and `progress`. Error(kCancelled) is all that is thrown.

/// The exact area: outer rings count positive, holes negative, whatever their orientation. O(n).
[[nodiscard]] MINKSUM_API Rational area(const Region& region, const Options& options = {});
/// The same as a double, correct to a few units in the last place unless it cancels; much faster.
[[nodiscard]] MINKSUM_API double approximate_area(const Region& region,
                                                  const Options& options = {});
/// The bounding box; nothing for an empty region. O(n).
[[nodiscard]] MINKSUM_API std::optional<Box> bounding_box(const Region& region,
                                                          const Options& options = {});
/// How many bits the coordinates need once scaled to integers by their least common denominator
/// and moved to the origin. An indication of which arithmetic a sum takes: that is picked on a grid
/// which both operands share, and which may be finer (docs/pipeline.md). O(n).
[[nodiscard]] MINKSUM_API std::size_t coordinate_bits(const Region& region,
                                                      const Options& options = {});

}  // namespace minksum

// Declares measures of a region. Areas are in squares of the unit of the coordinates.
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
  /// Tells whether both have the same corners.
  friend bool operator==(const Box&, const Box&) = default;
};

// Of the options, these functions use `cancel` and `progress`. They throw only Error(kCancelled).

/// Returns the exact area. Outer rings count positive and holes negative, in any orientation. O(n).
[[nodiscard]] MINKSUM_API Rational area(const Region& region, const Options& options = {});
/// Returns the area as a double, much faster. It is correct to a few units in the last place,
/// unless the shape is thin or far from the origin, or outer rings and holes nearly cancel. A shape
/// far from the origin has a relative error of at most 10⁻⁹. O(n).
[[nodiscard]] MINKSUM_API double approximate_area(const Region& region,
                                                  const Options& options = {});
/// Returns the exact bounding box, or nothing for an empty region. O(n).
[[nodiscard]] MINKSUM_API std::optional<Box> bounding_box(const Region& region,
                                                          const Options& options = {});
/// Returns how many bits the coordinates need after two steps: they are scaled to integers by their
/// least common denominator, and moved to the origin. This hints at the number type of a sum, which
/// depends on the grid that both operands share. That grid may be finer (docs/pipeline.md). O(n).
[[nodiscard]] MINKSUM_API std::size_t coordinate_bits(const Region& region,
                                                      const Options& options = {});

}  // namespace minksum

// Makes operands of any size from the folder of shapes: thinned real outlines, and real parts.
#pragma once

#include <cstddef>

#include "families.hpp"

namespace minksum::bench {

/// Returns the outline of Norway (20,981 vertices) without the vertices whose loss shows least.
/// This is Visvalingam and Whyatt's thinning, here without letting the outline cross itself. Empty
/// without the folder, and for more vertices than the outline has.
[[nodiscard]] Region thinned_outline(std::size_t vertices);
/// Returns the smallest nesting part of so many vertices or more, and the next larger one turned by
/// half a circle. Empty without the folder, and beyond the largest part.
[[nodiscard]] Operands parts_of_size(std::size_t vertices);

}  // namespace minksum::bench

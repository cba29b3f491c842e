// Operands of any size out of the folder of shapes: real outlines thinned, real parts picked.
#pragma once

#include <cstddef>

#include "families.hpp"

namespace minksum::bench {

/// The outline of Norway (20,981 vertices), less the vertices whose loss shows least:
/// Visvalingam and Whyatt's thinning, here without letting the outline cross itself. Empty without
/// the folder, and for more vertices than there are.
[[nodiscard]] Region thinned_outline(std::size_t vertices);
/// The smallest nesting part of so many vertices or more, and the next larger one turned by half a
/// circle; empty without the folder, and beyond the largest.
[[nodiscard]] Operands parts_of_size(std::size_t vertices);

}  // namespace minksum::bench

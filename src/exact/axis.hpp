// Names the axes of the plane.
#pragma once

namespace minksum {

enum class Axis : unsigned char { kX, kY };
/// Returns the other axis.
[[nodiscard]] constexpr Axis other(Axis axis) { return axis == Axis::kX ? Axis::kY : Axis::kX; }

}  // namespace minksum

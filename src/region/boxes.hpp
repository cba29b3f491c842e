// Declares exact boxes around sets.
#pragma once

#include <optional>

#include "machine/cancellation.hpp"
#include "minksum/geometry.hpp"
#include "minksum/measure.hpp"

namespace minksum {

/// Enlarges a box so that it contains a point. std::nullopt is the empty box.
void enlarge(std::optional<Box>& box, const Point& point);
/// Returns the box around a geometry, or nothing if that is empty.
[[nodiscard]] std::optional<Box> bounding_box(const Geometry& geometry, Cancellation& cancellation);
/// Returns a box that is `by` wider on all sides.
[[nodiscard]] Box widened(const Box& box, const Rational& by);
[[nodiscard]] Region as_region(const Box& box);

}  // namespace minksum

// Loads the coordinates of regions as points on one rung.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/region.hpp"
#include "overlay/exact_points.hpp"

namespace minksum::overlay {

/// A vertex of some region.
struct Source {
  const Region* region = nullptr;
  std::size_t vertex = 0;
};

/// Points, and the units of work (see Cancellation) of a decision about them.
struct LoadedPoints {
  std::unique_ptr<ExactPoints> points;
  std::uint64_t work = 0;
};
/// Loads all points on the narrowest rung that holds them. If one grid has up to 125 bits a side,
/// points are integers on that grid. Otherwise points are homogeneous integers, each with its own
/// denominator. O(n).
[[nodiscard]] LoadedPoints load_points(std::span<const Source> sources, Cancellation& cancellation);

}  // namespace minksum::overlay

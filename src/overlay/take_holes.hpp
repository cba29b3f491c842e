// Reads polygons that are not valid one by one: each is its outer ring's inside less its holes'.
#pragma once

#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum::overlay {

/// Returns the set that FillRule::kAutomatic reads from a geometry whose polygons need not be
/// valid. The set is resolved (see Geometry). O((n + c) log n), like `select`.
[[nodiscard]] Geometry take_holes_away(const Geometry& geometry, const Options& options);

}  // namespace minksum::overlay

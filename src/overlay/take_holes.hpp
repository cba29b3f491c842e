// Polygons that are not valid, read one by one: what the outer ring encloses less what holes do.
#pragma once

#include "minksum/resolve.hpp"

namespace minksum::overlay {

/// The set that FillRule::kAutomatic reads from a geometry whose polygons need not be valid;
/// resolved (see Geometry). O((n + c) log n), as `select`.
[[nodiscard]] Geometry take_holes_away(const Geometry& geometry, const ResolveOptions& options);

}  // namespace minksum::overlay

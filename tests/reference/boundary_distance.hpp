// Compares the distance of boundaries with a limit, edge by edge.
#pragma once

#include "minksum/geometry.hpp"

namespace minksum::reference {

/// Returns whether some vertex or end of the boundary of `from` is farther from that of `to` than
/// `distance`. Thin parts are boundary. Takes O(nm).
[[nodiscard]] bool farther_than(double distance, const Geometry& from, const Geometry& to);

}  // namespace minksum::reference

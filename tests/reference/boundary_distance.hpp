// How far boundaries are from one another, edge by edge.
#pragma once

#include "minksum/geometry.hpp"

namespace minksum::reference {

/// Returns whether some vertex or end of the boundary of `from` is farther from that of `to` than
/// `distance`. Thin parts are boundary. O(nm).
[[nodiscard]] bool farther_than(double distance, const Geometry& from, const Geometry& to);

}  // namespace minksum::reference

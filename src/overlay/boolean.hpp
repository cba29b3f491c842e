// Declares boolean operations on sets that are known to be valid.
#pragma once

#include <span>

#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum::overlay {

/// Does what minksum::unite does, for resolved geometries, and for valid regions alone.
[[nodiscard]] Geometry unite(std::span<const Geometry> geometries, const Options& options);
/// These do what the functions of the same names in minksum do, for valid regions.
[[nodiscard]] Region intersect(const Region& a, const Region& b, const Options& options);
[[nodiscard]] Region subtract(const Region& a, const Region& b, const Options& options);
[[nodiscard]] bool contains(const Region& b, const Region& a, const Options& options);

}  // namespace minksum::overlay

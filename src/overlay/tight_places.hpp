// Tells tight places from the other polylines and points of a geometry.
#pragma once

#include <utility>

#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum::overlay {

/// Tells whether polylines and points are kept as tight places: all of them lie within the area.
/// `set` is what the geometry means.
[[nodiscard]] inline bool keeps_tight_places(const Geometry& geometry, const Geometry& set,
                                             const Options& options) {
  return geometry.has_thin_parts() && !set.has_thin_parts() && !options.regularize &&
         options.tight.value_or(true);
}

/// Returns the polylines and points alone.
[[nodiscard]] inline Geometry tight_places_of(const Geometry& geometry) {
  return Geometry({}, geometry.polylines, geometry.points);
}

/// Returns a set without thin parts, with tight places.
[[nodiscard]] inline Geometry with_tight_places(Geometry set, Geometry tight) {
  set.polylines = std::move(tight.polylines);
  set.points = std::move(tight.points);
  return set;
}

}  // namespace minksum::overlay

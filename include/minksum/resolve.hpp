// Declares how rings of any kind become the set of points that they mean.
#pragma once

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// Returns the set of points that a geometry means by `options.fill`, exactly and in resolved form
/// (see Geometry). Rings may cross themselves and each other.
///
/// The area is the closure of the points that the fill rule encloses. A ring's own points belong to
/// the set, except those that holes take away by kAutomatic. So spikes and rings that collapse
/// become polylines or points where no area holds them. Where rings cross, vertices are rational
/// points. `options.regularize` drops everything that has no area.
///
/// O((n + c) log n) for n vertices and c places where edges meet. Throws Error: kBadInput by
/// kStrict for a ring that is not valid, whose culprit has `operand`, polygon, ring and vertex;
/// kLimitExceeded as the functions of boolean.hpp do; kCancelled.
[[nodiscard]] MINKSUM_API Geometry resolve(const Geometry& geometry, const Options& options = {},
                                           int operand = -1);

/// Returns the same, but keeps tight places: polylines and points that all lie within the area, as
/// those of a no-fit polygon do. As parts of the set they would vanish. They are resolved by
/// themselves instead. If some lie elsewhere, or `options.tight` is false, this is `resolve`.
/// Complexity and errors are the same.
[[nodiscard]] MINKSUM_API Geometry resolve_with_tight_places(const Geometry& geometry,
                                                             const Options& options = {});

}  // namespace minksum

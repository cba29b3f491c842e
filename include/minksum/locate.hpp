// Declares point location: where points lie with respect to a set that is asked many times.
#pragma once

#include <memory>

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// Says where a point lies with respect to a set.
enum class Location {
  kOutside,   ///< the point is not in the set
  kBoundary,  ///< the point is on the boundary of the area, on a polyline, or on a single point
  kInside,    ///< the point is in the interior of the area
};

/// A geometry that is prepared for point location. Copies share one state, and any number of threads
/// may ask.
///
/// It is a segment tree over the heights of vertices. Each edge is kept at the O(log n) nodes whose
/// range of heights it spans, in the order from left to right. Source: Preparata, Shamos,
/// "Computational Geometry", 1985, section 2.2.
class MINKSUM_API PointLocator {
 public:
  /// Prepares the set that a geometry means by `options.fill` (see `resolve`). O(n log n) time and
  /// memory for n vertices of a valid region, and the time of `resolve` besides for other
  /// geometries. Throws the errors of `resolve`.
  explicit PointLocator(const Geometry& geometry, const Options& options = {});
  /// Copies share the state, and so does an object with what was moved from it.
  PointLocator(const PointLocator&) = default;
  PointLocator& operator=(const PointLocator&) = default;
  ~PointLocator() = default;

  /// Returns exactly where the point lies. O(log² n).
  [[nodiscard]] Location locate(const Point& point) const;

  struct State;

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace minksum

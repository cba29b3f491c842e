// Where points lie with respect to a set, asked many times.
#pragma once

#include <memory>

#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/options.hpp"

namespace minksum {

/// Where a point lies.
enum class Location {
  kOutside,   ///< it is not of the set
  kBoundary,  ///< on the boundary of the area, on a polyline, or on a single point
  kInside,    ///< in the inside of the area
};

/// A resolved geometry, prepared for point location. Copies share it; any number of
/// threads may ask.
///
/// A segment tree over the heights of vertices: each edge is kept, in order from left to right, at
/// the O(log n) nodes whose range of heights it spans (Preparata, Shamos 1985, section 2.2).
/// O(n log n) time and memory to build.
class MINKSUM_API PointLocator {
 public:
  /// Throws Error(kCancelled).
  explicit PointLocator(const Geometry& geometry, const Options& options = {});

  /// Exactly where the point is: in the inside of the area, on its boundary or on a thin part, or
  /// elsewhere. O(log² n).
  [[nodiscard]] Location locate(const Point& point) const;

  struct State;

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace minksum

// No-fit and inner-fit polygons: where parts can be placed.
#pragma once

#include <optional>

#include "minksum/locate.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

struct NestingOptions {
  /// The point of the moving part that says where it is; without it the part's first vertex, as given.
  std::optional<Point> reference;
  FillRule fill = FillRule::kAutomatic;  ///< how both shapes are read
  Limits limits;
  std::optional<CancelToken> cancel;
};

/// The no-fit polygon of `moving` around `fixed`: placements t of the reference point. In the inside
/// of its area the parts overlap; on its boundary, and on its polylines and points (tight places),
/// they touch; elsewhere they are apart. It is (fixed ⊕ −moving) + reference; thin parts of both shapes
/// are dropped. Orientation of rings has no meaning. Throws as minkowski_sum does, and
/// Error(kBadInput) if `moving` has no vertex to be the reference point.
[[nodiscard]] Geometry no_fit_polygon(const Geometry& fixed, const Geometry& moving,
                                      const NestingOptions& options = {});

/// The inner-fit polygon of `part` in `bin`: the placements t of the reference point that put the part
/// into the bin (touching is allowed). It is (bin ⊖ part) + reference, with the placements that leave
/// no play as polylines and points. Empty if the part does not fit.
[[nodiscard]] Geometry inner_fit_polygon(const Geometry& bin, const Geometry& part,
                                         const NestingOptions& options = {});

/// How a placed part relates to a fixed one.
enum class Contact { kFree, kTouching, kOverlapping };

/// A no-fit polygon to be asked many times. Copies share it; any number of threads may ask.
class NoFitPolygon {
 public:
  NoFitPolygon(const Geometry& fixed, const Geometry& moving, const NestingOptions& options = {});

  [[nodiscard]] const Geometry& geometry() const { return geometry_; }
  /// The relation at placement t of the reference point, exactly; O(log² n).
  [[nodiscard]] Contact contact(const Point& t) const;

 private:
  Geometry geometry_;
  PointLocator locator_;
  PointLocator tight_;
};

}  // namespace minksum

#include <utility>

#include "minksum/morphology.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/transform.hpp"

namespace minksum {
namespace {

Geometry read(const Geometry& geometry, const NoFitOptions& options, int operand) {
  return resolve(geometry, {options.fill, true, options.cancel, operand});
}

/// The reference point of a shape as it was given.
Point reference_of(const Geometry& moving, const NoFitOptions& options) {
  if (options.reference) return *options.reference;
  if (!moving.region.empty()) return moving.region.point(0);
  Culprit second;
  second.operand = 1;
  throw Error(ErrorCode::kBadInput, "a part without area has no reference point", second);
}

/// Moved by `by`; the form stays canonical.
Geometry moved(const Geometry& geometry, const Point& by, const NoFitOptions& options) {
  return transform(geometry, Affine::translation(by.x, by.y), options.cancel);
}

}  // namespace

Geometry no_fit_polygon(const Geometry& fixed, const Geometry& moving,
                        const NoFitOptions& options) {
  const Point reference = reference_of(moving, options);
  Geometry tight;
  Options sum;
  sum.limits = options.limits;
  sum.cancel = options.cancel;
  sum.tight = &tight;
  Geometry result = minkowski_sum(read(fixed, options, 0),
                                  reflect(read(moving, options, 1), options.cancel), sum);
  result.polylines = std::move(tight.polylines);
  result.points = std::move(tight.points);
  return moved(result, reference, options);
}

Geometry inner_fit_polygon(const Geometry& bin, const Geometry& part, const NoFitOptions& options) {
  const Point reference = reference_of(part, options);
  MorphologyOptions erosion;
  erosion.tight = true;
  erosion.limits = options.limits;
  erosion.cancel = options.cancel;
  return moved(erode(read(bin, options, 0), read(part, options, 1), erosion), reference, options);
}

NoFitPolygon::NoFitPolygon(const Geometry& fixed, const Geometry& moving,
                           const NoFitOptions& options)
    : geometry_(no_fit_polygon(fixed, moving, options)),
      locator_({geometry_.region, {}, {}}, options.cancel),
      tight_({{}, geometry_.polylines, geometry_.points}, options.cancel) {}

Contact NoFitPolygon::contact(const Point& t) const {
  switch (locator_.locate(t)) {
    case Location::kOutside:
      return Contact::kFree;
    case Location::kBoundary:
      return Contact::kTouching;
    case Location::kInside:
      break;
  }
  return tight_.locate(t) == Location::kBoundary ? Contact::kTouching : Contact::kOverlapping;
}

}  // namespace minksum

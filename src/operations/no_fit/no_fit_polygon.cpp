#include <utility>

#include "machine/cancellation.hpp"
#include "minksum/morphology.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/transform.hpp"
#include "overlay/resolve_area.hpp"
#include "validation/fault.hpp"

namespace minksum {
namespace {

/// Returns the reference point of a shape as it was given.
Point reference_of(const Geometry& moving, const std::optional<Point>& reference) {
  if (reference) return *reference;
  if (!moving.region.empty()) return moving.region.point(0);
  refuse_operand("a part without area has no reference point", 1);
}

/// Returns the geometry moved by `by`. A canonical form stays canonical.
Geometry moved(const Geometry& geometry, const Point& by, const Options& options) {
  return transform(geometry, Affine::translation(by.x, by.y), options);
}

/// Returns the options of a sum or an erosion of resolved shapes.
Options with_tight_places(const Options& options) {
  Options part = part_of(options);
  part.tight = options.tight.value_or(true);
  return part;
}

}  // namespace

Geometry no_fit_polygon(const Geometry& fixed, const Geometry& moving,
                        const std::optional<Point>& reference, const Options& options) {
  const Point at = reference_of(moving, reference);
  DetailedSum sum =
      detailed_sum(resolve_area(fixed, 0, options),
                   reflect(resolve_area(moving, 1, options), options), with_tight_places(options));
  sum.sum.polylines = std::move(sum.tight.polylines);
  sum.sum.points = std::move(sum.tight.points);
  return moved(sum.sum, at, options);
}

Geometry inner_fit_polygon(const Geometry& bin, const Geometry& part,
                           const std::optional<Point>& reference, const Options& options) {
  const Point at = reference_of(part, reference);
  const Geometry room = resolve_area(bin, 0, options);
  const Geometry piece = resolve_area(part, 1, options);
  if (piece.empty() && !part.empty()) refuse_operand("a part without area fits everywhere", 1);
  return moved(erode(room, piece, with_tight_places(options)), at, options);
}

NoFitPolygon::NoFitPolygon(const Geometry& fixed, const Geometry& moving,
                           const std::optional<Point>& reference, const Options& options)
    : geometry_(no_fit_polygon(fixed, moving, reference, options)),
      locator_({geometry_.region, {}, {}}, part_of(options)),
      tight_({{}, geometry_.polylines, geometry_.points}, part_of(options)) {}

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

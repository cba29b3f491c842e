#include "rounding/grow.hpp"

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {
namespace {

Region box(const Point& low, const Point& high) {
  Polygon polygon;
  polygon.outer = {low, {high.x, low.y}, high, {low.x, high.y}};
  return Region(polygon);
}

Region square(const Rational& half) { return box({-half, -half}, {half, half}); }

}  // namespace

Region grown(const Region& region, const Rational& half, const std::optional<CancelToken>& cancel) {
  Options options;
  options.cancel = cancel;
  return minkowski_sum(region, square(half), options);
}

Region grown(const Geometry& geometry, const Rational& half,
             const std::optional<CancelToken>& cancel) {
  Options options;
  options.cancel = cancel;
  return minkowski_sum(geometry, Geometry{square(half), {}, {}}, options).region;
}

Region shrunk(const Region& region, const Rational& half,
              const std::optional<CancelToken>& cancel) {
  const auto around = bounding_box(region, cancel);
  if (!around) return {};
  // Any frame that the region does not touch will do.
  const Rational margin = half + half;
  const Region frame = box({around->min.x - margin, around->min.y - margin},
                           {around->max.x + margin, around->max.y + margin});
  return subtract(frame, grown(subtract(frame, region, cancel), half, cancel), cancel);
}

}  // namespace minksum

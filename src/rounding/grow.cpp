#include "rounding/grow.hpp"

#include "machine/cancellation.hpp"
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

Region grown(const Region& region, const Rational& half, const Options& options) {
  return minkowski_sum(region, square(half), part_of(options));
}

Region grown(const Geometry& geometry, const Rational& half, const Options& options) {
  return minkowski_sum(geometry, Geometry{square(half), {}, {}}, part_of(options)).region;
}

Region shrunk(const Region& region, const Rational& half, const Options& options) {
  const auto around = bounding_box(region, options);
  if (!around) return {};
  // Any frame that the region does not touch will do.
  const Rational margin = half + half;
  const Region frame = box({around->min.x - margin, around->min.y - margin},
                           {around->max.x + margin, around->max.y + margin});
  return subtract(frame, grown(subtract(frame, region, options), half, options), options);
}

}  // namespace minksum

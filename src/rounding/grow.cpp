#include "rounding/grow.hpp"

#include "machine/cancellation.hpp"
#include "minksum/minkowski_sum.hpp"
#include "overlay/boolean.hpp"
#include "region/boxes.hpp"

namespace minksum {
namespace {

Region square(const Rational& half) { return as_region(widened(Box{}, half)); }

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
  const Region frame = as_region(widened(*around, half + half));
  return overlay::subtract(frame, grown(overlay::subtract(frame, region, options), half, options),
                           options);
}

}  // namespace minksum

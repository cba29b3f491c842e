#include "minksum/morphology.hpp"

#include <utility>

#include "machine/cancellation.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "overlay/boolean.hpp"
#include "region/boxes.hpp"
#include "validation/fault.hpp"

namespace minksum {
namespace {

/// Returns the erosion of resolved operands.
Geometry eroded(const Region& a, const Geometry& b, const Options& options) {
  Geometry result;
  if (a.empty()) return result;
  // x + B ⊆ A puts x into A's box moved by −b, for every b of B. So x is within B's size of A's box
  // moved by one −b. The frame reaches beyond that by B's size again, so complement ⊕ −B encloses
  // all such x.
  Cancellation cancellation(options);
  const Box size = *bounding_box(b, cancellation);
  const Rational reach = size.max.x - size.min.x + size.max.y - size.min.y + Rational(1);
  const Box box = *bounding_box(a, options);
  const Region frame = overlay::subtract(as_region(widened(box, reach + reach)), a, options);
  const Box where = widened({{box.min.x - size.max.x, box.min.y - size.max.y},
                             {box.max.x - size.min.x, box.max.y - size.min.y}},
                            Rational(1));
  Options part = part_of(options);
  part.tight = options.tight;
  DetailedSum outside = detailed_sum(Geometry(frame), reflect(b, options), part);
  result.region = overlay::subtract(as_region(where), outside.sum.region, options);
  result.polylines = std::move(outside.tight.polylines);
  result.points = std::move(outside.tight.points);
  // A polyline may pass through a corner of the area. A resolved one ends there.
  if (result.has_thin_parts()) return resolve(result, part_of(options));
  return result;
}

/// Returns B, resolved. Throws if there is no erosion by B.
Geometry usable_element(const Geometry& b, const Options& options) {
  Geometry element = resolve(b, options, 1);
  if (element.empty()) refuse_operand("erosion by an empty set would be the whole plane", 1);
  if (options.tight.value_or(false) && element.has_thin_parts()) {
    refuse_operand("tight places of an element with thin parts are not known", 1);
  }
  return element;
}

}  // namespace

Geometry dilate(const Geometry& a, const Geometry& b, const Options& options) {
  return minkowski_sum(a, b, options);
}

Geometry erode(const Geometry& a, const Geometry& b, const Options& options) {
  const Geometry element = usable_element(b, options);
  return eroded(resolve(a, options, 0).region, element, options);
}

Geometry open(const Geometry& a, const Geometry& b, const Options& options) {
  const Geometry element = usable_element(b, options);
  const Geometry inner = eroded(resolve(a, options, 0).region, element, options);
  return minkowski_sum(inner, element, part_of(options));
}

Geometry close(const Geometry& a, const Geometry& b, const Options& options) {
  const Geometry element = usable_element(b, options);
  const Geometry sum = minkowski_sum(resolve(a, options, 0), element, part_of(options));
  return eroded(sum.region, element, options);
}

}  // namespace minksum

#include "minksum/morphology.hpp"

#include <utility>

#include "machine/cancellation.hpp"
#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"

namespace minksum {
namespace {

void add(Box& box, const Point& point) {
  if (point.x < box.min.x) box.min.x = point.x;
  if (point.y < box.min.y) box.min.y = point.y;
  if (box.max.x < point.x) box.max.x = point.x;
  if (box.max.y < point.y) box.max.y = point.y;
}

Box box_of(const Geometry& geometry, const Options& options) {
  Cancellation cancellation(options);
  Box box;
  if (const auto areal = bounding_box(geometry.region, options)) {
    box = *areal;
  } else {
    const Point& any =
        geometry.polylines.empty() ? geometry.points.front() : geometry.polylines.front().front();
    box = {any, any};
  }
  for (const Polyline& line : geometry.polylines) {
    for (const Point& point : line) add(box, point);
    cancellation.check(line.size() * work_of(line.front()));
  }
  for (const Point& point : geometry.points) {
    cancellation.check(work_of(point));
    add(box, point);
  }
  return box;
}

Ring corners(const Box& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

/// Returns a box that is `by` wider on all sides.
Box widened(const Box& box, const Rational& by) {
  return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}};
}

/// Returns the erosion of resolved operands.
Geometry eroded(const Region& a, const Geometry& b, const Options& options) {
  Geometry result;
  if (a.empty()) return result;
  // x + B ⊆ A puts x into A's box moved by −b, for every b of B. So x is within B's size of A's box
  // moved by one −b. The frame reaches beyond that by B's size again, so complement ⊕ −B encloses
  // all such x.
  const Box size = box_of(b, options);
  const Rational reach = size.max.x - size.min.x + size.max.y - size.min.y + Rational(1);
  const Box box = *bounding_box(a, options);
  const Region frame =
      subtract(Region(Polygon{corners(widened(box, reach + reach)), {}}), a, options);
  const Box where = widened({{box.min.x - size.max.x, box.min.y - size.max.y},
                             {box.max.x - size.min.x, box.max.y - size.min.y}},
                            Rational(1));
  Options part = part_of(options);
  part.tight = options.tight;
  DetailedSum outside = detailed_sum(Geometry(frame), reflect(b, options), part);
  result.region = subtract(Region(Polygon{corners(where), {}}), outside.sum.region, options);
  result.polylines = std::move(outside.tight.polylines);
  result.points = std::move(outside.tight.points);
  return result;
}

/// Returns B, resolved. Throws if there is no erosion by B.
Geometry usable_element(const Geometry& b, const Options& options) {
  Geometry element = resolve(b, options, 1);
  Culprit second;
  second.operand = 1;
  if (element.empty()) {
    throw Error(ErrorCode::kBadInput, "erosion by an empty set would be the whole plane", second);
  }
  if (options.tight.value_or(false) && element.has_thin_parts()) {
    throw Error(ErrorCode::kBadInput, "tight places of an element with thin parts are not known",
                second);
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

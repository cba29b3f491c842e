#include "region/boxes.hpp"

#include <algorithm>

#include "region/map_points.hpp"

namespace minksum {

void enlarge(std::optional<Box>& box, const Point& point) {
  if (!box) box = Box{point, point};
  box->min = {std::min(box->min.x, point.x), std::min(box->min.y, point.y)};
  box->max = {std::max(box->max.x, point.x), std::max(box->max.y, point.y)};
}

std::optional<Box> bounding_box(const Geometry& geometry, Cancellation& cancellation) {
  std::optional<Box> box = bounding_box(geometry.region, cancellation.options());
  const auto add = [&](const Point& point) {
    cancellation.check(4 * work_of(point));
    enlarge(box, point);
  };
  for_each_thin_point(geometry, add);
  return box;
}

Box widened(const Box& box, const Rational& by) {
  return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}};
}

Region as_region(const Box& box) {
  return Region(Polygon{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}});
}

}  // namespace minksum

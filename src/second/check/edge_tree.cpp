#include "second/check/edge_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "region/point_predicates.hpp"

namespace minksum::checking {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr DoubleBox kNothing{kInfinity, kInfinity, -kInfinity, -kInfinity};

}  // namespace

DoubleBox around(const Corner& c) {
  if (!std::isfinite(c.error)) return kEverything;
  return {c.x - c.error, c.y - c.error, c.x + c.error, c.y + c.error};
}

Corner::Corner(const Point& point)
    : vertex(&point),
      moved_to(nullptr),
      x(point.x.to_double()),
      y(point.y.to_double()),
      error(rounding_error(std::max(std::abs(x), std::abs(y)))) {}

Corner::Corner(const Corner& at, const Corner& corner)
    : vertex(corner.vertex), moved_to(at.vertex), x(at.x - corner.x), y(at.y - corner.y) {
  error = 2 * (at.error + corner.error) + rounding_error(std::max(std::abs(x), std::abs(y)));
}

EdgeTree::EdgeTree(const Geometry& geometry, Cancellation& cancellation) {
  const Region& region = geometry.region;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      const std::size_t first = points_.size();
      for (const std::size_t v : region.vertices_of(ring)) {
        cancellation.check(4);
        points_.push_back(region.point(v));
      }
      add_path(first, true);
    }
  }
  for (const Polyline& line : geometry.polylines) {
    const std::size_t first = points_.size();
    points_.insert(points_.end(), line.begin(), line.end());
    add_path(first, false);
  }
  for (const Point& point : geometry.points) {
    heads_.push_back(points_.size());
    edges_.push_back({points_.size(), points_.size()});
    points_.push_back(point);
  }
  corners_.reserve(points_.size());
  for (const Point& point : points_) {
    const std::uint64_t work = work_of(point);
    cancellation.check(work);
    work_ = std::max(work_, work);
    corners_.emplace_back(point);
  }
  build(cancellation);
}

std::size_t EdgeTree::last_edge(std::size_t leaf) const {
  return std::min(edges_.size(), first_edge(leaf) + kLeaf);
}

void EdgeTree::add_path(std::size_t first, bool closed) {
  const std::size_t last = points_.size();
  if (first == last) return;
  heads_.push_back(first);
  for (std::size_t i = first; i + 1 < last; ++i) edges_.push_back({i, i + 1});
  if (closed) edges_.push_back({last - 1, first});
}

void EdgeTree::build(Cancellation& cancellation) {
  while (leaves_ * kLeaf < edges_.size()) leaves_ *= 2;
  boxes_.assign(2 * leaves_, kNothing);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    cancellation.check(2);
    DoubleBox& box = boxes_[leaves_ + e / kLeaf];
    box.add(around(corners_[edges_[e].from]));
    box.add(around(corners_[edges_[e].to]));
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    boxes_[node] = boxes_[2 * node];
    boxes_[node].add(boxes_[2 * node + 1]);
  }
}

}  // namespace minksum::checking

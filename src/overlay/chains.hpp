// Turns regions and geometries into chains of an overlay.
#pragma once

#include <vector>

#include "machine/cancellation.hpp"
#include "overlay/overlay.hpp"

namespace minksum::overlay {

/// Stores polylines and points as rings of a region, which serves as a store of points only.
class ThinStore {
 public:
  /// Adds polylines and points. Each becomes a chain without weight that belongs, and points into
  /// this store.
  void add(const Geometry& geometry, Cancellation& cancellation) {
    for (const Polyline& line : geometry.polylines) add(line, cancellation);
    for (const Point& point : geometry.points) add(std::span(&point, 1), cancellation);
  }
  void list_chains(std::vector<Chain>& chains) const {
    for (std::size_t ring = 0; ring < points_.ring_count(); ++ring) {
      const IndexRange vertices = points_.vertices_of(ring);
      Chain chain;
      chain.region = &points_;
      chain.begin = vertices.front();
      chain.end = chain.begin + vertices.size();
      chain.closed = false;
      chain.belongs = true;
      chains.push_back(chain);
    }
  }

 private:
  void add(std::span<const Point> points, Cancellation& cancellation) {
    if (points.empty()) return;
    if (points_.polygon_count() == 0) points_.begin_polygon();
    points_.begin_ring();
    for (const Point& p : points) {
      cancellation.check(16);
      points_.add_vertex(p.x, p.y);
    }
  }
  Region points_;
};

/// Calls add(chain, is_hole) for each ring.
template <class Add>
void for_each_ring(const Region& region, Add add) {
  for (const std::size_t polygon : region.polygons()) {
    const IndexRange rings = region.rings_of(polygon);
    for (const std::size_t ring : rings) {
      const IndexRange vertices = region.vertices_of(ring);
      Chain chain;
      chain.region = &region;
      chain.begin = vertices.front();
      chain.end = chain.begin + vertices.size();
      add(chain, ring != rings.front());
    }
  }
}

/// Adds the rings of a region, directed so that outer rings run counter-clockwise and holes
/// clockwise.
template <class SetUp>
void list_by_role(const Region& region, std::vector<Chain>& chains, SetUp set_up) {
  for_each_ring(region, [&](Chain chain, bool is_hole) {
    chain.direction = is_hole ? Chain::Direction::kClockwise : Chain::Direction::kCounterClockwise;
    set_up(chain);
    chains.push_back(chain);
  });
}

/// Adds the rings of a region, all with one weight.
inline void add_rings(const Region& region, const Winding& weight, std::vector<Chain>& chains) {
  for_each_ring(region, [&](Chain chain, bool) {
    chain.weight = weight;
    chains.push_back(chain);
  });
}

}  // namespace minksum::overlay

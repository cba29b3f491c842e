// Converts nodes to exact coordinates.
#pragma once

#include "overlay/subdivision.hpp"
#include "region/region_access.hpp"

namespace minksum::overlay {

[[nodiscard]] inline Point exact_point(const Segments& segments, const Node& node) {
  if (node.place.is_crossing) return segments.predicates.exact().exact(node.place);
  const Source& source = segments.sources[node.place.point()];
  return source.region->point(source.vertex);
}

/// Appends a node to a region. Given points are copied as they are stored.
inline void add_vertex(const Segments& segments, const Node& node, Region& region) {
  if (node.place.is_crossing) {
    const Point p = segments.predicates.exact().exact(node.place);
    region.add_vertex(p.x, p.y);
  } else {
    const Source& source = segments.sources[node.place.point()];
    RegionAccess::copy_vertex(region, *source.region, source.vertex);
  }
}

}  // namespace minksum::overlay

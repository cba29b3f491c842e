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

/// Tells whether a path turns between two pieces. `same_way` tells whether it goes along both from
/// low to high, or along both from high to low.
inline bool turns(const Segments& segments, const Piece& a, const Piece& b, bool same_way) {
  if (a.segment == b.segment) return false;
  return !same_way || segments.predicates.cross(segments.list[a.segment].ends,
                                                segments.list[b.segment].ends) != kZero;
}

}  // namespace minksum::overlay

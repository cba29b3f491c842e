// Sets of points of any dimension: areas, polylines and points together.
#pragma once

#include <utility>
#include <vector>

#include "minksum/region.hpp"

namespace minksum {

/// A path along its vertices, two or more; closed if the last one repeats the first.
using Polyline = std::vector<Point>;

/// The union of polygons, polylines and points: what an operand may be, and a sum of such.
///
/// As such it promises nothing: rings may cross themselves and one another. Results of operations
/// are *resolved*: `region` is valid and canonical (see Region); polylines and points are outside
/// of it, but for ends of polylines on its boundary; polylines are simple and meet only at their
/// ends, of which no two could be joined without making a branch; each starts at its
/// lexicographically smaller end (a closed one at its smallest vertex, then towards the smaller
/// neighbour); no vertex is in the middle of a straight run; polylines and points are sorted. So
/// equal sets compare equal.
struct Geometry {
  Region region;                    ///< what has area
  std::vector<Polyline> polylines;  ///< what has length alone
  std::vector<Point> points;        ///< what has neither

  Geometry() = default;
  /// An area alone converts by itself.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Geometry(Region area, std::vector<Polyline> lines = {}, std::vector<Point> alone = {})
      : region(std::move(area)), polylines(std::move(lines)), points(std::move(alone)) {}

  /// Whether there is nothing at all.
  [[nodiscard]] bool empty() const { return region.empty() && !has_thin_parts(); }
  /// Whether there is anything without area.
  [[nodiscard]] bool has_thin_parts() const { return !polylines.empty() || !points.empty(); }
  /// Whether all parts are equal as stored. Equal sets are, if both are resolved.
  friend bool operator==(const Geometry&, const Geometry&) = default;
};

}  // namespace minksum

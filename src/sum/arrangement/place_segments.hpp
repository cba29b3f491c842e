// Places segments in doubles.
#pragma once

#include <cmath>

#include "sum/arrangement/arrangement.hpp"

namespace minksum {

/// Makes a kept segment that is not known to meet the cover.
inline KeptSegment place_segment(const Operands& o, const Segment& segment, const Clip& clip) {
  const auto& [x, y, dx, dy, next] = o.sites;
  const auto& [e, v] = segment;
  const SiteId f = next[e];
  const DirectionRank rank = o.rank[e];
  const std::uint32_t line = std::min(o.place[rank], o.reverse_place[rank]);
  return {{x[e] + x[v], y[e] + y[v]},
          {x[f] + x[v], y[f] + y[v]},
          {dx[e], dy[e]},
          segment,
          0,
          line,
          rank,
          false,
          clip};
}

/// A segment's line in units of cells.
struct CellLine {
  Vec<double> start;
  double rise;  ///< height / width, or 0 where that would magnify rounding much
  CellLine(const KeptSegment& s, const UniformGrid& grid)
      : start{s.a.x * grid.inverse.x, s.a.y * grid.inverse.y}, rise(0) {
    const double width = (s.b.x - s.a.x) * grid.inverse.x;
    const double height = (s.b.y - s.a.y) * grid.inverse.y;
    const bool flat = std::abs(height) <= 4 * std::abs(width);
    if (flat && std::abs(width) > UniformGrid::kMargin) rise = height / width;
  }
  [[nodiscard]] double height_at(double x) const { return start.y + (x - start.x) * rise; }
};

}  // namespace minksum

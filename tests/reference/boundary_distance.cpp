#include "reference/boundary_distance.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "reference/exact.hpp"

namespace minksum::reference {
namespace {

Number squared_distance(const Pt& p, const Pt& a, const Pt& b) {
  const Number dx = b.x - a.x;
  const Number dy = b.y - a.y;
  const Number length = dx * dx + dy * dy;
  Number t = length == 0 ? Number(0) : Number(((p.x - a.x) * dx + (p.y - a.y) * dy) / length);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Number ex = p.x - a.x - t * dx;
  const Number ey = p.y - a.y - t * dy;
  return ex * ex + ey * ey;
}

/// Returns edges, segments of polylines, and points as segments without length.
std::vector<std::array<Pt, 2>> boundary_of(const Geometry& geometry) {
  std::vector<std::array<Pt, 2>> boundary;
  for (const auto& loops : to_loops(geometry.region)) {
    for (const auto& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        boundary.push_back({loop[i], loop[(i + 1) % loop.size()]});
      }
    }
  }
  for (const Polyline& line : geometry.polylines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      boundary.push_back({to_pt(line[i]), to_pt(line[i + 1])});
    }
  }
  for (const Point& p : geometry.points) boundary.push_back({to_pt(p), to_pt(p)});
  return boundary;
}

}  // namespace

bool farther_than(double distance, const Geometry& from, const Geometry& to) {
  const Number limit = to_number(Rational(distance) * Rational(distance));
  const auto target = boundary_of(to);
  const auto far = [&](const Pt& p) {
    return std::none_of(target.begin(), target.end(), [&](const auto& edge) {
      return squared_distance(p, edge[0], edge[1]) <= limit;
    });
  };
  const auto ends = boundary_of(from);
  return std::any_of(ends.begin(), ends.end(),
                     [&](const auto& edge) { return far(edge[0]) || far(edge[1]); });
}

}  // namespace minksum::reference

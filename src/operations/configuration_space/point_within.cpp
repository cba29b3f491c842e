// Finds a point inside a region, well away from its boundary.
#include <algorithm>
#include <cmath>
#include <optional>

#include "operations/configuration_space/free_part.hpp"

namespace minksum {
namespace {

constexpr int kGrid = 24;  ///< points to look at along each axis

struct Edge {
  double ax, ay, bx, by;
};

std::vector<Edge> edges_of(const Region& region, Cancellation& cancellation) {
  std::vector<Edge> edges;
  for_each_edge(region, [&](std::size_t v, std::size_t w) {
    cancellation.check(16);
    edges.push_back({region.x(v), region.y(v), region.x(w), region.y(w)});
  });
  return edges;
}

double squared_distance(const Edge& edge, double x, double y) {
  const double dx = edge.bx - edge.ax;
  const double dy = edge.by - edge.ay;
  const double whole = dx * dx + dy * dy;
  const double along = (x - edge.ax) * dx + (y - edge.ay) * dy;
  const double t = whole > 0 ? std::clamp(along / whole, 0.0, 1.0) : 0;
  const double px = x - edge.ax - t * dx;
  const double py = y - edge.ay - t * dy;
  return px * px + py * py;
}

/// Returns about how far inside a point is, and 0 outside.
double clearance(const std::vector<Edge>& edges, double x, double y) {
  bool inside = false;
  double nearest = HUGE_VAL;
  for (const Edge& e : edges) {
    nearest = std::min(nearest, squared_distance(e, x, y));
    if ((e.ay > y) != (e.by > y) && x < e.ax + (y - e.ay) / (e.by - e.ay) * (e.bx - e.ax)) {
      inside = !inside;
    }
  }
  return inside ? std::sqrt(nearest) : 0;
}

/// A candidate, and its cost: smaller is better.
struct Candidate {
  double cost;
  double x, y;
};

/// Returns points of a grid in the box that seem to be inside, with few bits, the best first. It is
/// good to be far from the boundary, up to a part of the box, and to be on a short way.
std::vector<Candidate> candidates(const Region& region, const Point& from, const Point& to,
                                  const Options& options) {
  Cancellation cancellation(options, Stage::kSearch);
  const std::optional<Box> box = bounding_box(region, options);
  const double x0 = box->min.x.to_double();
  const double y0 = box->min.y.to_double();
  const double width = box->max.x.to_double() - x0;
  const double height = box->max.y.to_double() - y0;
  std::vector<Candidate> found;
  const double size = std::max(width, height);
  if (!(size > 0) || !std::isfinite(size)) return found;
  const std::vector<Edge> edges = edges_of(region, cancellation);
  // The step is a power of two that is fine enough for the shorter side. Underflow makes it 0.
  const double step = std::ldexp(1.0, std::ilogb(std::min(width, height) / kGrid) - 3);
  if (!(step > 0)) return found;
  const auto cost = [&](double x, double y, double room) {
    const auto away = [&](const Point& p) {
      return std::hypot(x - p.x.to_double(), y - p.y.to_double());
    };
    return away(from) + away(to) - 8 * std::min(room, size / 16);
  };
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const double x = std::nearbyint((x0 + width * (i + 0.5) / kGrid) / step) * step;
      const double y = std::nearbyint((y0 + height * (j + 0.5) / kGrid) / step) * step;
      cancellation.check(edges.size());
      const double room = clearance(edges, x, y);
      if (room > 0) found.push_back({cost(x, y, room), x, y});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return found;
}

/// Returns a height that no vertex of a polygon has: the middle of the largest gap between heights
/// of its vertices. A level line there crosses the polygon, which is connected.
Rational height_between(const Region& region, std::size_t polygon, Cancellation& cancellation) {
  std::vector<Rational> heights;
  for (const std::size_t ring : region.rings_of(polygon)) {
    for (const std::size_t v : region.vertices_of(ring)) heights.push_back(region.exact_y(v));
  }
  const auto below = [&](const Rational& a, const Rational& b) {
    cancellation.check(work_of_product(a.bits()));
    return a < b;
  };
  std::sort(heights.begin(), heights.end(), below);
  std::size_t best = 1;
  for (std::size_t i = 2; i < heights.size(); ++i) {
    cancellation.check(4 * work_of_product(heights[i].bits()));
    if (heights[i] - heights[i - 1] > heights[best] - heights[best - 1]) best = i;
  }
  return (heights[best] + heights[best - 1]) * Rational(1, 2);
}

/// Returns a point of the first polygon, in the middle between two edges that a level line crosses.
Point exact_point(const Region& region, const Options& options) {
  Cancellation cancellation(options, Stage::kSearch);
  const std::size_t polygon = region.polygons().front();
  const Rational y = height_between(region, polygon, cancellation);
  std::vector<Rational> crossings;
  for (const std::size_t ring : region.rings_of(polygon)) {
    const IndexRange vertices = region.vertices_of(ring);
    Point a = region.point(vertices.front() + vertices.size() - 1);
    for (const std::size_t v : vertices) {
      const Point b = region.point(v);
      cancellation.check(8 * work_of(b));
      if ((a.y > y) != (b.y > y)) {
        crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
      }
      a = b;
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::size_t best = 1;
  for (std::size_t i = 3; i < crossings.size(); i += 2) {
    if (crossings[i] - crossings[i - 1] > crossings[best] - crossings[best - 1]) best = i;
  }
  return {(crossings[best - 1] + crossings[best]) * Rational(1, 2), y};
}

}  // namespace

Point point_within(const Region& region, const Point& from, const Point& to,
                   const Options& options) {
  const PointLocator locator({region, {}, {}}, part_of(options));
  for (const Candidate& candidate : candidates(region, from, to, options)) {
    const Point point{Rational(candidate.x), Rational(candidate.y)};
    if (locator.locate(point) == Location::kInside) return point;
  }
  return exact_point(region, options);
}

}  // namespace minksum

#include "minksum/depth.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/locate.hpp"
#include "minksum/transform.hpp"
#include "operations/penetration/contact.hpp"
#include "overlay/resolve_area.hpp"
#include "region/point_arithmetic.hpp"

namespace minksum {
namespace {

struct Shape {
  Geometry geometry;
  bool as_given = false;  ///< whether its vertices are those that the caller knows
};

Shape read(const Geometry& geometry, const Options& options, int operand) {
  if (is_plain(geometry, options)) return {geometry, true};
  return {resolve(geometry, options, operand), false};
}

/// A ⊕ −B, with thin parts where a shape has some, and with its tight places.
struct Obstacle {
  Shape a;
  Shape b;
  Geometry sum;
  Geometry tight;
};

std::optional<Obstacle> obstacle(const Geometry& a, const Geometry& b, const Options& options) {
  Obstacle result{read(a, options, 0), read(b, options, 1), {}, {}};
  if (result.a.geometry.empty() || result.b.geometry.empty()) return std::nullopt;
  Options part = part_of(options);
  part.tight = true;
  DetailedSum sum = detailed_sum(result.a.geometry, reflect(result.b.geometry, options), part);
  result.sum = std::move(sum.sum);
  result.tight = std::move(sum.tight);
  return result;
}

struct Edge {
  Point a;
  Point b;
  bool thin = false;  ///< a thin part of the sum, or a tight place
};

std::vector<Edge> edges_of(const Obstacle& obstacle, Cancellation& cancellation) {
  std::vector<Edge> edges;
  const Region& region = obstacle.sum.region;
  for_each_edge(region, [&](std::size_t v, std::size_t w) {
    edges.push_back({region.point(v), region.point(w)});
    cancellation.check(work_of(edges.back().a));
  });
  for (const Geometry* thin : {&obstacle.sum, &obstacle.tight}) {
    for (const Polyline& line : thin->polylines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        edges.push_back({line[i], line[i + 1], true});
      }
    }
    for (const Point& point : thin->points) edges.push_back({point, point, true});
  }
  return edges;
}

/// Returns the point of an edge that is nearest to the origin.
Point nearest_point(const Edge& edge) {
  const Point d = minus(edge.b, edge.a);
  const Rational along = -dot(edge.a, d);
  if (along.sign() <= 0) return edge.a;
  const Rational whole = dot(d, d);
  if (along >= whole) return edge.b;
  const Rational t = along / whole;
  return {edge.a.x + d.x * t, edge.a.y + d.y * t};
}

/// Returns a lower bound on an edge's distance from the origin: that of its box, amply rounded
/// down.
double distance_at_least(const Edge& edge) {
  const auto gap = [](const Rational& from, const Rational& to) {
    if (from.sign() * to.sign() <= 0) return 0.0;
    return std::min(std::abs(from.to_double()), std::abs(to.to_double()));
  };
  const double far = std::hypot(gap(edge.a.x, edge.b.x), gap(edge.a.y, edge.b.y));
  return std::isfinite(far) ? far * (1 - 0x1p-48) : 0;
}

struct Nearest {
  Point point;
  Rational squared;
  const Edge* edge = nullptr;
};

Nearest nearest_of(const std::vector<Edge>& edges, Cancellation& cancellation) {
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    cancellation.check(work_of(edges[i].a));
    order.emplace_back(distance_at_least(edges[i]), i);
  }
  std::sort(order.begin(), order.end(), cancellation.counting(std::less<>()));
  std::optional<Nearest> best;
  for (const auto& [far, i] : order) {
    if (best && Rational(far) * Rational(far) > best->squared) break;
    cancellation.check(16 * work_of(edges[i].a));
    const Point point = nearest_point(edges[i]);
    Rational squared = dot(point, point);
    const bool better =
        !best || squared < best->squared ||
        (squared == best->squared &&
         (point.x < best->point.x || (point.x == best->point.x && point.y < best->point.y)));
    // Of edges with the same nearest point, only one that is not thin tells what is in contact.
    const bool says_more = best && point == best->point && best->edge->thin && !edges[i].thin;
    if (better || says_more) best = Nearest{point, std::move(squared), &edges[i]};
  }
  return *best;
}

}  // namespace

std::optional<Depth> penetration_depth(const Geometry& a, const Geometry& b,
                                       const Options& options) {
  const auto around = obstacle(a, b, options);
  if (!around) return std::nullopt;
  Cancellation cancellation(options, Stage::kSearch);
  const std::vector<Edge> edges = edges_of(*around, cancellation);
  Nearest nearest = nearest_of(edges, cancellation);
  Depth depth;
  depth.overlapping =
      nearest.squared.sign() != 0 &&
      PointLocator(around->sum, part_of(options)).locate({Rational(0), Rational(0)}) ==
          Location::kInside;
  depth.vector = nearest.point;
  depth.distance = std::hypot(nearest.point.x.to_double(), nearest.point.y.to_double());
  depth.squared = std::move(nearest.squared);
  if (!nearest.edge->thin && around->a.as_given && around->b.as_given) {
    depth.contact =
        find_contact(around->a.geometry.region, around->b.geometry.region, nearest.point,
                     minus(nearest.edge->b, nearest.edge->a), cancellation);
  }
  return depth;
}

std::optional<Rational> time_of_impact(const Geometry& a, const Geometry& b, const Point& direction,
                                       const Options& options) {
  if (direction.x.sign() == 0 && direction.y.sign() == 0) {
    refuse_input("a direction must not be (0, 0)");
  }
  const auto around = obstacle(a, b, options);
  if (!around) return std::nullopt;
  if (PointLocator(around->sum, part_of(options)).locate({Rational(0), Rational(0)}) !=
      Location::kOutside) {
    return Rational(0);
  }
  // The ray's first point in the sum lies on an edge. The ray crosses that edge, or meets its end
  // if both are parallel.
  const Rational whole = dot(direction, direction);
  std::optional<Rational> first;
  const auto offer = [&first](const Rational& factor) {
    if (factor.sign() >= 0 && (!first || factor < *first)) first = factor;
  };
  Cancellation cancellation(options, Stage::kSearch);
  for (const Edge& edge : edges_of(*around, cancellation)) {
    cancellation.check(16 * work_of(edge.a));
    const int from = cross(direction, edge.a).sign();
    const int to = cross(direction, edge.b).sign();
    if (from == 0) offer(dot(direction, edge.a) / whole);
    if (to == 0) offer(dot(direction, edge.b) / whole);
    if (from * to >= 0) continue;
    const Point along = minus(edge.b, edge.a);
    offer(cross(edge.a, along) / cross(direction, along));
  }
  return first;
}

}  // namespace minksum

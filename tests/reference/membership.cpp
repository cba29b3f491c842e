#include "reference/membership.hpp"

#include <algorithm>
#include <stdexcept>

namespace minksum::reference {
namespace {

struct Edge {
  Pt a;
  Pt b;
  Number min_x, max_x, min_y, max_y;
};

std::vector<Edge> edges_of(const std::vector<Loops>& polygons) {
  std::vector<Edge> edges;
  for (const Loops& loops : polygons) {
    for (const Loop& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Pt& a = loop[i];
        const Pt& b = loop[(i + 1) % loop.size()];
        edges.push_back(
            {a, b, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)});
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.min_x < f.min_x; });
  return edges;
}

bool any_edges_meet(const std::vector<Edge>& first, const std::vector<Edge>& second) {
  for (const Edge& e : first) {
    for (const Edge& f : second) {
      if (f.min_x > e.max_x) break;  // sorted by min_x
      if (f.max_x < e.min_x || f.max_y < e.min_y || f.min_y > e.max_y) continue;
      if (segments_meet(e.a, e.b, f.a, f.b)) return true;
    }
  }
  return false;
}

Side locate_in(const Pt& p, const Loops& polygon) {
  const Side outer = locate(p, polygon[0]);
  if (outer != Side::kInside) return outer;
  for (std::size_t h = 1; h < polygon.size(); ++h) {
    const Side hole = locate(p, polygon[h]);
    if (hole == Side::kBoundary) return Side::kBoundary;
    if (hole == Side::kInside) return Side::kOutside;
  }
  return Side::kInside;
}

Side locate_in(const Pt& p, const std::vector<Loops>& polygons) {
  for (const Loops& polygon : polygons) {
    const Side side = locate_in(p, polygon);
    if (side != Side::kOutside) return side;
  }
  return Side::kOutside;
}

}  // namespace

Side locate(const Pt& p, const Region& region) { return locate_in(p, to_loops(region)); }

bool contains_sum(const Region& p, const Region& q, const Pt& x) {
  const std::vector<Loops> still = to_loops(p);
  std::vector<Loops> moved = to_loops(q);
  for (Loops& loops : moved) {
    for (Loop& loop : loops) {
      for (Pt& v : loop) v = {Number(x.x - v.x), Number(x.y - v.y)};
    }
  }
  if (any_edges_meet(edges_of(still), edges_of(moved))) return true;
  // No boundaries meet, so a part of one lies wholly inside the other, or they are disjoint.
  for (const Loops& part : still) {
    if (locate_in(part[0][0], moved) != Side::kOutside) return true;
  }
  for (const Loops& part : moved) {
    if (locate_in(part[0][0], still) != Side::kOutside) return true;
  }
  return false;
}

Pt point_strictly_inside(const Loops& polygon) {
  // The vertical line is halfway between the two smallest different x. On it, the lowest two
  // crossings bound a stretch of the inside.
  std::vector<Number> xs;
  for (const Loop& ring : polygon) {
    for (const Pt& p : ring) xs.push_back(p.x);
  }
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  if (xs.size() < 2) throw std::logic_error("a polygon without area");
  const Number x = (xs[0] + xs[1]) / 2;
  std::vector<Number> ys;
  for (const Loop& ring : polygon) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Pt& a = ring[i];
      const Pt& b = ring[(i + 1) % ring.size()];
      if ((a.x < x) == (b.x < x)) continue;
      ys.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
    }
  }
  std::sort(ys.begin(), ys.end());
  return {x, (ys.at(0) + ys.at(1)) / 2};
}

std::vector<Pt> points_near_edges(const Region& region, const Number& distance) {
  std::vector<Pt> points;
  for (const Loops& loops : to_loops(region)) {
    for (const Loop& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Pt& a = loop[i];
        const Pt& b = loop[(i + 1) % loop.size()];
        const Pt m = midpoint(a, b);
        const Number nx = (b.y - a.y) * distance;
        const Number ny = (a.x - b.x) * distance;
        points.push_back(m);
        points.push_back({Number(m.x + nx), Number(m.y + ny)});
        points.push_back({Number(m.x - nx), Number(m.y - ny)});
      }
    }
  }
  return points;
}

}  // namespace minksum::reference

#include "list_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "peers/stopwatch.hpp"

namespace minksum::bench {
namespace {

struct Site {
  std::int32_t x;
  std::int32_t y;
};
struct Edge {
  Site from;
  Site to;
  [[nodiscard]] std::int64_t dx() const { return to.x - from.x; }
  [[nodiscard]] std::int64_t dy() const { return to.y - from.y; }
};
using Edges = std::vector<Edge>;

std::int64_t cross(const Edge& a, const Edge& b) { return a.dx() * b.dy() - a.dy() * b.dx(); }
bool upper(const Edge& e) { return e.dy() > 0 || (e.dy() == 0 && e.dx() > 0); }
// Order by angle in [0, 360) degrees.
bool before(const Edge& a, const Edge& b) {
  if (upper(a) != upper(b)) return upper(a);
  return cross(a, b) > 0;
}

struct Box {
  double width = 0;
  double height = 0;
};

Box box_of(const Region& region, std::size_t ring) {
  double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
  for (const std::size_t v : region.vertices_of(ring)) {
    low_x = std::min(low_x, region.x(v));
    high_x = std::max(high_x, region.x(v));
    low_y = std::min(low_y, region.y(v));
    high_y = std::max(high_y, region.y(v));
  }
  return {high_x - low_x, high_y - low_y};
}

double largest(const Region& region) {
  double result = 0;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    result = std::max({result, std::abs(region.x(v)), std::abs(region.y(v))});
  }
  return result;
}

struct Rings {
  std::vector<std::vector<Site>> rings;
  [[nodiscard]] std::size_t edges() const {
    std::size_t count = 0;
    for (const auto& ring : rings) count += ring.size();
    return count;
  }
};

std::int64_t twice_area(const std::vector<Site>& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Site a = ring[i];
    const Site b = ring[(i + 1) % ring.size()];
    sum += (std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x) / 4;  // the sign will do
  }
  return sum;
}

Rings round_rings(const Region& region, double scale, const Box& other) {
  Rings result;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      const bool is_hole = ring != region.rings_of(polygon).front();
      const Box box = box_of(region, ring);
      if (is_hole && (box.width <= other.width || box.height <= other.height)) continue;
      std::vector<Site> sites;
      for (const std::size_t v : region.vertices_of(ring)) {
        const Site site{static_cast<std::int32_t>(std::lround(region.x(v) * scale)),
                        static_cast<std::int32_t>(std::lround(region.y(v) * scale))};
        if (sites.empty() || site.x != sites.back().x || site.y != sites.back().y) {
          sites.push_back(site);
        }
      }
      if ((twice_area(sites) < 0) != is_hole) std::reverse(sites.begin(), sites.end());
      result.rings.push_back(std::move(sites));
    }
  }
  return result;
}

void sort_edges(const Rings& rings, Edges& edges) {
  edges.clear();
  for (const auto& ring : rings.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
    }
  }
  std::sort(edges.begin(), edges.end(), before);
}

void list_run(Edges::const_iterator from, Edges::const_iterator to, Site v, Edges& out) {
  for (auto e = from; e != to; ++e) {
    out.push_back({{e->from.x + v.x, e->from.y + v.y}, {e->to.x + v.x, e->to.y + v.y}});
  }
}

// For each convex vertex of `rings` its run of `edges`, which are sorted: directions from [in, out)
// or, with `closed_end`, from (in, out].
void list_runs(const Rings& rings, const Edges& edges, bool closed_end, Edges& out) {
  const auto first_from = [&](const Edge& e) {
    return closed_end ? std::upper_bound(edges.begin(), edges.end(), e, before)
                      : std::lower_bound(edges.begin(), edges.end(), e, before);
  };
  for (const auto& ring : rings.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Site v = ring[i];
      const Edge in{ring[i == 0 ? ring.size() - 1 : i - 1], v};
      const Edge next{v, ring[i + 1 == ring.size() ? 0 : i + 1]};
      if (cross(in, next) <= 0) continue;
      if (!before(next, in)) {
        list_run(first_from(in), first_from(next), v, out);
      } else {
        list_run(first_from(in), edges.end(), v, out);
        list_run(edges.begin(), first_from(next), v, out);
      }
    }
  }
}

}  // namespace

Listing list_convolution(const Region& p, const Region& q) {
  const double scale = 0x1p29 / std::max(largest(p), largest(q));
  const Rings rings_p = round_rings(p, scale, box_of(q, 0));
  const Rings rings_q = round_rings(q, scale, box_of(p, 0));
  Edges edges_p;
  Edges edges_q;
  Edges list;
  std::vector<double> seconds;
  for (int i = 0; i < 7; ++i) {
    const Stopwatch watch;
    sort_edges(rings_p, edges_p);
    sort_edges(rings_q, edges_q);
    list.clear();
    list_runs(rings_p, edges_q, false, list);
    list_runs(rings_q, edges_p, true, list);
    seconds.push_back(watch.seconds());
  }
  std::sort(seconds.begin(), seconds.end());
  return {list.size(), seconds[seconds.size() / 2]};
}

}  // namespace minksum::bench

#include "support/polygon_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "reference/canonical.hpp"
#include "reference/convex_pieces.hpp"
#include "reference/validity.hpp"

namespace minksum::test {
namespace {

std::int64_t cross(const Vertex& o, const Vertex& a, const Vertex& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

Outline random_vertices(Random& random, int count, int size) {
  Outline points;
  while (static_cast<int>(points.size()) < count) {
    const Vertex v = random_vertex(random, size);
    if (std::find(points.begin(), points.end(), v) == points.end()) points.push_back(v);
  }
  return points;
}

// Tries until `make` gives a valid outline; returns a triangle if too many tries fail.
template <class Make>
Region until_valid(Random& random, int size, Make&& make) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    const Outline outline = make();
    if (outline.size() < 3) continue;
    Region region = make_polygon(outline);
    if (reference::validity_fault(region).empty()) return region;
  }
  return random_triangle(random, size);
}

}  // namespace

Vertex random_vertex(Random& random, int size) {
  const int x = random.between(0, size);
  return {x, random.between(0, size)};
}

Region random_triangle(Random& random, int size) {
  for (;;) {
    const Outline p = random_vertices(random, 3, size);
    if (cross(p[0], p[1], p[2]) != 0) return make_polygon(p);
  }
}

Region random_star_shaped(Random& random, int count, int size) {
  return until_valid(random, size, [&] {
    const Vertex centre{size / 2, size / 2};
    Outline points = random_vertices(random, count, size);
    std::erase(points, centre);
    const auto half = [&](const Vertex& v) {
      return v.y > centre.y || (v.y == centre.y && v.x > centre.x) ? 0 : 1;
    };
    const auto same_direction = [&](const Vertex& a, const Vertex& b) {
      return half(a) == half(b) && cross(centre, a, b) == 0;
    };
    std::stable_sort(points.begin(), points.end(), [&](const Vertex& a, const Vertex& b) {
      return half(a) != half(b) ? half(a) < half(b) : cross(centre, a, b) > 0;
    });
    points.erase(std::unique(points.begin(), points.end(), same_direction), points.end());
    return points;
  });
}

Region random_two_opt(Random& random, int count, int size) {
  return until_valid(random, size, [&] {
    Outline p = random_vertices(random, count, size);
    const std::size_t n = p.size();
    const auto crosses = [&](std::size_t i, std::size_t j) {
      const Vertex &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
      const auto sign = [](std::int64_t v) { return v < 0 ? -1 : v > 0 ? 1 : 0; };
      return sign(cross(a, b, c)) * sign(cross(a, b, d)) <= 0 &&
             sign(cross(c, d, a)) * sign(cross(c, d, b)) <= 0;
    };
    for (int round = 0; round < 60; ++round) {
      bool changed = false;
      for (std::size_t i = 0; i + 2 < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
          if ((i == 0 && j + 1 == n) || !crosses(i, j)) continue;
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          changed = true;
        }
      }
      if (!changed) break;
    }
    return p;
  });
}

Region random_convex(Random& random, int count, int size) {
  return until_valid(random, size, [&] {
    reference::IntLoop<std::int64_t> points;
    for (const Vertex& v : random_vertices(random, count, size)) points.push_back({v.x, v.y});
    Outline hull;
    for (const auto& p : reference::convex_hull(points)) hull.push_back({p.x, p.y});
    return hull;
  });
}

namespace {

// Collects the boundary edges of unit triangles. An edge that two triangles share vanishes.
class Board {
 public:
  void add_triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
    add(a, b);
    add(b, c);
    add(c, a);
  }
  Region region(const std::vector<std::int64_t>& xs, const std::vector<std::int64_t>& ys) const {
    reference::Loops ring_per_edge;
    std::vector<reference::Pt> nodes;
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> ids;
    const auto id = [&](const std::pair<std::int64_t, std::int64_t>& p) {
      const auto [it, is_new] = ids.try_emplace(p, nodes.size());
      if (is_new) {
        nodes.push_back({reference::Number(xs[static_cast<std::size_t>(p.first)]),
                         reference::Number(ys[static_cast<std::size_t>(p.second)])});
      }
      return it->second;
    };
    std::vector<reference::Piece> pieces;
    for (const auto& [from, to] : edges_) {
      const std::size_t start = id(from);
      pieces.push_back({start, id(to)});
    }
    return reference::link(nodes, pieces);
  }

 private:
  using GridPoint = std::pair<std::int64_t, std::int64_t>;
  void add(const Vertex& a, const Vertex& b) {
    const GridPoint from{a.x, a.y};
    const GridPoint to{b.x, b.y};
    if (edges_.erase({to, from}) == 0) edges_.insert({from, to});
  }
  std::set<std::pair<GridPoint, GridPoint>> edges_;
};

std::vector<std::int64_t> random_lines(Random& random, int count) {
  std::vector<std::int64_t> lines{0};
  const bool even = random.one_in(2);
  for (int i = 0; i < count; ++i) lines.push_back(lines.back() + (even ? 1 : random.between(1, 3)));
  return lines;
}

void fill_cell(Board& board, Random& random, int i, int j, bool halves) {
  const Vertex a{i, j}, b{i + 1, j}, c{i + 1, j + 1}, d{i, j + 1};
  const int kind = halves ? random.below(8) : 4;
  if (kind == 0) board.add_triangle(a, b, c);
  if (kind == 1) board.add_triangle(a, c, d);
  if (kind == 2) board.add_triangle(a, b, d);
  if (kind == 3) board.add_triangle(b, c, d);
  if (kind >= 4) {
    board.add_triangle(a, b, c);
    board.add_triangle(a, c, d);
  }
}

}  // namespace

Region random_cells(Random& random, int columns, int rows, bool halves, bool connected) {
  for (;;) {
    Board board;
    const int density = random.between(2, 4);
    bool any = false;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        if (random.one_in(density + 1)) continue;
        fill_cell(board, random, i, j, halves);
        any = true;
      }
    }
    const std::vector<std::int64_t> xs = random_lines(random, columns);
    const std::vector<std::int64_t> ys = random_lines(random, rows);
    if (!any) continue;
    Region region = board.region(xs, ys);
    if (!connected || region.polygon_count() == 1) return region;
  }
}

Region random_with_holes(Random& random, int size, int holes) {
  const Region body = random.one_in(2) ? rectangle(0, 0, size, size)
                                       : random_star_shaped(random, random.between(5, 10), size);
  Polygon polygon = body.polygon(0);
  for (int h = 0; h < holes; ++h) {
    for (int attempt = 0; attempt < 8; ++attempt) {
      const int small = random.between(1, std::max(1, size / 2));
      const int dy = random.between(0, size - small);
      const int dx = random.between(0, size - small);
      const Region hole = moved(random_two_opt(random, random.between(3, 5), small + 1), dx, dy);
      Polygon more = polygon;
      more.holes.push_back(hole.polygon(0).outer);
      if (!reference::validity_fault(Region(more)).empty()) continue;
      polygon = std::move(more);
      break;
    }
  }
  return Region(polygon);
}

Region comb(int teeth, std::int64_t width, std::int64_t height) {
  Outline outline{{0, 0}, {(2 * teeth - 1) * width, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const std::int64_t x = 2 * i * width;
    outline.push_back({x + width, width + height});
    outline.push_back({x, width + height});
    if (i > 0) {
      outline.push_back({x, width});
      outline.push_back({x - width, width});
    }
  }
  return make_polygon(outline);
}

Region spiral(int turns) {
  // The wall's outer line goes inwards, and its inner line back out; the wall lies between them.
  Outline out;
  Outline back;
  const std::int64_t size = 4 * turns + 1;
  for (int t = 0; t < turns; ++t) {
    const std::int64_t low = 2 * t;
    const std::int64_t high = size - low;
    const std::int64_t start = t == 0 ? 0 : low - 2;
    const std::int64_t inner_start = t == 0 ? 0 : low - 1;
    const std::int64_t inner_end = t + 1 == turns ? low : low + 1;
    out.insert(out.end(), {{start, low}, {high, low}, {high, high}, {low, high}});
    back.insert(
        back.end(),
        {{inner_start, low + 1}, {high - 1, low + 1}, {high - 1, high - 1}, {inner_end, high - 1}});
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  return make_polygon(out);
}

Region spiky_star(Random& random, int spikes, int radius) {
  constexpr double kTwoPi = 6.283185307179586;
  Outline outline;
  for (int i = 0; i < 2 * spikes; ++i) {
    const double jitter = 0.3 * random.below(1000) / 1000.0;
    const double angle = kTwoPi * (i + jitter) / (2 * spikes);
    const double far = radius * (i % 2 == 0 ? 1.0 : 0.3) * (800 + random.below(200)) / 1000.0;
    outline.push_back({std::llround(far * std::cos(angle)), std::llround(far * std::sin(angle))});
  }
  return make_polygon(outline);
}

Region round_polygon(int corners, int radius) {
  constexpr double kTwoPi = 6.283185307179586;
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = kTwoPi * i / corners;
    const Vertex v{std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))};
    if (outline.empty() || !(outline.back() == v)) outline.push_back(v);
  }
  return make_polygon(outline);
}

Region frame(const std::vector<Outline>& holes, std::int64_t margin) {
  Vertex low = holes.at(0).at(0);
  Vertex high = low;
  for (const Outline& hole : holes) {
    for (const Vertex& v : hole) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y)};
    }
  }
  low = {low.x - margin, low.y - margin};
  high = {high.x + margin, high.y + margin};
  return make_polygon({low, {high.x, low.y}, high, {low.x, high.y}}, holes);
}

}  // namespace minksum::test

#include "outlines.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "support/data.hpp"

namespace minksum::bench {
namespace {

struct Corner {
  double x;
  double y;
};

double twice_area(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A ring from which vertices are removed one by one.
class Thinned {
 public:
  explicit Thinned(const Region& region) {
    const std::size_t n = region.vertices_of(0).size();
    for (std::size_t v = 0; v < n; ++v) corners_.push_back({region.x(v), region.y(v)});
    for (std::size_t v = 0; v < n; ++v) {
      next_.push_back((v + 1) % n);
      previous_.push_back((v + n - 1) % n);
    }
    left_ = n;
    for (std::size_t v = 0; v < n; ++v) push(v);
  }

  void thin(std::size_t size) {
    while (left_ > size && !queue_.empty()) {
      const auto [area, v] = queue_.top();
      queue_.pop();
      if (next_[v] == v || -area != area_of(v)) continue;  // removed, or its triangle has changed
      if (!can_go(v)) continue;  // a neighbour must go first and change its triangle
      next_[previous_[v]] = next_[v];
      previous_[next_[v]] = previous_[v];
      push(previous_[v]);
      push(next_[v]);
      next_[v] = v;
      --left_;
    }
  }
  [[nodiscard]] std::vector<std::size_t> vertices() const {
    std::vector<std::size_t> result;
    for (std::size_t v = 0; v < next_.size(); ++v) {
      if (next_[v] != v) result.push_back(v);
    }
    return result;
  }

 private:
  [[nodiscard]] double area_of(std::size_t v) const {
    return std::abs(twice_area(corners_[previous_[v]], corners_[v], corners_[next_[v]]));
  }
  void push(std::size_t v) { queue_.push({-area_of(v), v}); }
  // Returns whether no other vertex lies in the triangle that is cut off or filled, or on its
  // border.
  [[nodiscard]] bool can_go(std::size_t v) const {
    Corner a = corners_[previous_[v]];
    const Corner b = corners_[v];
    Corner c = corners_[next_[v]];
    if (twice_area(a, b, c) < 0) std::swap(a, c);
    const std::size_t end = previous_[v];
    for (std::size_t i = next_[next_[v]]; i != end; i = next_[i]) {
      const Corner& at = corners_[i];
      if (twice_area(a, b, at) >= 0 && twice_area(b, c, at) >= 0 && twice_area(c, a, at) >= 0) {
        return false;
      }
    }
    return true;
  }

  std::vector<Corner> corners_;
  std::vector<std::size_t> next_;  // the vertex itself = removed
  std::vector<std::size_t> previous_;
  std::priority_queue<std::pair<double, std::size_t>> queue_;  // least area first
  std::size_t left_ = 0;
};

}  // namespace

Region thinned_outline(std::size_t vertices) {
  Region result;
  const auto data = test::data_path();
  if (!data || !exists(*data / "cgal/norway.wkt")) return result;
  const Region outline = test::read_wkt(*data / "cgal/norway.wkt");
  if (vertices > outline.vertex_count()) return result;
  Thinned thinned(outline);
  thinned.thin(vertices);
  result.begin_polygon();
  result.begin_ring();
  for (const std::size_t v : thinned.vertices()) {
    result.add_vertex(outline.exact_x(v), outline.exact_y(v));
  }
  return result;
}

Operands parts_of_size(std::size_t vertices) {
  const auto data = test::data_path();
  if (!data) return {};
  std::vector<std::pair<std::size_t, std::string>> parts;
  for (const auto& file : test::read_manifest(*data)) {
    if (file.name.starts_with("nesting/") && file.is_valid && file.parts == 1 && file.holes == 0) {
      parts.emplace_back(file.vertices, file.name);
    }
  }
  std::sort(parts.begin(), parts.end());
  const auto at = std::lower_bound(parts.begin(), parts.end(), std::pair(vertices, std::string()));
  if (parts.end() - at < 2) return {};
  return {test::read_wkt(*data / at[0].second), negated(test::read_wkt(*data / at[1].second))};
}

}  // namespace minksum::bench

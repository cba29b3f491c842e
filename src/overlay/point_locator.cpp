#include <algorithm>
#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "minksum/locate.hpp"
#include "overlay/resolve_area.hpp"
#include "region/point_predicates.hpp"

namespace minksum {
struct PointLocator::State {
  /// An edge. In `nodes`, edges are directed upwards, and none is level.
  struct Edge {
    std::uint32_t low;
    std::uint32_t high;
    bool of_ring;
    bool odd_before = false;  ///< whether an odd number of ring edges come before this one in its
                              ///< node
  };
  /// A closed range of one height, which belongs to the boundary.
  struct Level {
    std::uint32_t left;
    std::uint32_t right;
  };

  std::vector<RoundedPoint> places;
  std::vector<std::uint32_t> heights;      ///< places, one for each height, from below
  std::vector<std::vector<Level>> levels;  ///< by height: vertices and level edges
  std::uint64_t work = 0;                  ///< greatest work of a decision: see Cancellation
  std::size_t leaves = 1;                  ///< leaf i: from height i (included) to i + 1 (excluded)
  std::vector<std::vector<Edge>> nodes;    ///< 1 = root; children 2i, 2i + 1

  State(const Geometry& geometry, Cancellation& cancellation) {
    std::vector<Edge> edges;
    add_edges(geometry, cancellation, edges);
    if (places.empty()) return;
    const std::vector<std::uint32_t> height_of = rank_heights(cancellation);
    levels.resize(heights.size());
    while (leaves < heights.size()) leaves *= 2;
    nodes.resize(2 * leaves);
    for (std::uint32_t v = 0; v < places.size(); ++v) levels[height_of[v]].push_back({v, v});
    for (const Edge& edge : edges) {
      cancellation.check(8);
      const std::uint32_t low = height_of[edge.low];
      const std::uint32_t high = height_of[edge.high];
      if (low == high) {
        const bool forward = compare_x(places[edge.low], places[edge.high]) <= 0;
        levels[low].push_back(forward ? Level{edge.low, edge.high} : Level{edge.high, edge.low});
      } else if (low < high) {
        insert(edge, low, high);
      } else {
        insert({edge.high, edge.low, edge.of_ring}, high, low);
      }
    }
    for (auto& level : levels) merge(level, cancellation);
    for (auto& node : nodes) sort(node, cancellation);
  }

  void add_edges(const Geometry& geometry, Cancellation& cancellation, std::vector<Edge>& edges) {
    const auto add_place = [&](const Point& point) {
      const std::uint64_t work_here = work_of(point);
      cancellation.check(work_here);
      work = std::max(work, work_here);
      places.emplace_back(point);
    };
    const Region& region = geometry.region;
    for (const std::size_t polygon : region.polygons()) {
      for (const std::size_t ring : region.rings_of(polygon)) {
        if (region.vertices_of(ring).empty()) continue;
        const auto first = static_cast<std::uint32_t>(places.size());
        for (const std::size_t v : region.vertices_of(ring)) add_place(region.point(v));
        add_path(first, true, edges);
        edges.push_back({static_cast<std::uint32_t>(places.size()) - 1, first, true});
      }
    }
    for (const Polyline& line : geometry.polylines) {
      const auto first = static_cast<std::uint32_t>(places.size());
      for (const Point& point : line) add_place(point);
      add_path(first, false, edges);
    }
    for (const Point& point : geometry.points) add_place(point);
  }
  void add_path(std::uint32_t first, bool of_ring, std::vector<Edge>& edges) const {
    for (std::uint32_t v = first; v + 1 < places.size(); ++v) edges.push_back({v, v + 1, of_ring});
  }

  /// Fills `heights`, and returns the index of each place's height.
  std::vector<std::uint32_t> rank_heights(Cancellation& cancellation) {
    std::vector<std::uint32_t> sorted(places.size());
    for (std::uint32_t v = 0; v < sorted.size(); ++v) sorted[v] = v;
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
      cancellation.check(work);
      return compare_y(places[a], places[b]) < 0;
    });
    std::vector<std::uint32_t> height_of(places.size());
    for (const std::uint32_t v : sorted) {
      cancellation.check(work);
      if (heights.empty() || compare_y(places[heights.back()], places[v]) != 0) {
        heights.push_back(v);
      }
      height_of[v] = static_cast<std::uint32_t>(heights.size() - 1);
    }
    return height_of;
  }

  void insert(const Edge& edge, std::size_t first, std::size_t last) {
    std::size_t a = first + leaves;
    std::size_t b = last + leaves;
    for (; a < b; a /= 2, b /= 2) {
      if (a % 2 == 1) nodes[a++].push_back(edge);
      if (b % 2 == 1) nodes[--b].push_back(edge);
    }
  }

  /// Sorts edges that span the same heights and do not cross. An edge that has an end on the left
  /// of another one comes before it.
  void sort(std::vector<Edge>& node, Cancellation& cancellation) const {
    std::sort(node.begin(), node.end(), [&](const Edge& a, const Edge& b) {
      cancellation.check(4 * work);
      if (a.low == b.low && a.high == b.high) return false;
      // Some end of a or of b lies within the common heights, and beside the other edge.
      const int s = beside(b, a);
      return s != 0 ? s > 0 : beside(a, b) < 0;
    });
    bool odd = false;
    for (Edge& edge : node) {
      edge.odd_before = odd;
      odd ^= edge.of_ring;
    }
  }
  /// Tests the ends of `other` at a height of `edge`. Returns 1 if one is left of `edge`, -1 if one
  /// is right, and 0 if neither tells.
  [[nodiscard]] int beside(const Edge& edge, const Edge& other) const {
    for (const std::uint32_t v : {other.low, other.high}) {
      if (compare_y(places[edge.low], places[v]) > 0) continue;
      if (compare_y(places[edge.high], places[v]) < 0) continue;
      const int s = turn(places[edge.low], places[edge.high], places[v]);
      if (s != 0) return s;
    }
    return 0;
  }

  /// Sorts the ranges of one height from left to right, and joins those that touch.
  void merge(std::vector<Level>& level, Cancellation& cancellation) const {
    cancellation.check(2 * level.size());
    std::sort(level.begin(), level.end(), [&](const Level& a, const Level& b) {
      cancellation.check(work);
      return compare_x(places[a.left], places[b.left]) < 0;
    });
    std::size_t kept = 0;
    for (const Level& range : level) {
      if (kept > 0 && compare_x(places[range.left], places[level[kept - 1].right]) <= 0) {
        Level& last = level[kept - 1];
        if (compare_x(places[last.right], places[range.right]) < 0) last.right = range.right;
      } else {
        level[kept++] = range;
      }
    }
    level.resize(kept);
  }

  [[nodiscard]] bool on_level(std::size_t height, const RoundedPoint& at) const {
    const auto& level = levels[height];
    const auto after = std::partition_point(level.begin(), level.end(), [&](const Level& range) {
      return compare_x(places[range.left], at) <= 0;
    });
    return after != level.begin() && compare_x(at, places[(after - 1)->right]) <= 0;
  }

  [[nodiscard]] Location locate(const RoundedPoint& at) const {
    const auto above = std::partition_point(heights.begin(), heights.end(), [&](std::uint32_t v) {
      return compare_y(places[v], at) <= 0;
    });
    if (above == heights.begin()) return Location::kOutside;
    const auto height = static_cast<std::size_t>(above - heights.begin()) - 1;
    if (compare_y(places[heights[height]], at) == 0 && on_level(height, at)) {
      return Location::kBoundary;
    }
    bool odd = false;
    for (std::size_t n = height + leaves; n > 0; n /= 2) {
      // Edges that have the point on their right come first, then those through it.
      const auto& node = nodes[n];
      const auto first = std::partition_point(node.begin(), node.end(), [&](const Edge& edge) {
        return turn(places[edge.low], places[edge.high], at) < 0;
      });
      if (first != node.end() && turn(places[first->low], places[first->high], at) == 0) {
        return Location::kBoundary;
      }
      if (first != node.end()) {
        odd ^= first->odd_before;
      } else if (!node.empty()) {
        odd ^= node.back().odd_before != node.back().of_ring;
      }
    }
    return odd ? Location::kInside : Location::kOutside;
  }
};

PointLocator::PointLocator(const Geometry& geometry, const Options& options) {
  Cancellation cancellation(options);
  state_ = std::make_shared<const State>(read_operand(geometry, -1, options), cancellation);
}

Location PointLocator::locate(const Point& point) const {
  return state_->places.empty() ? Location::kOutside : state_->locate(RoundedPoint(point));
}

}  // namespace minksum

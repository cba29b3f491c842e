// Any maximal set of diagonals that do not cross is a triangulation. Then a diagonal is removed if
// the merged piece is convex. The time is quadratic to cubic, and the code is plain.
#include "reference/convex_pieces.hpp"

#include <algorithm>
#include <stdexcept>

namespace minksum::reference {
namespace {

template <class Int>
class Cutter {
 public:
  explicit Cutter(const std::vector<IntLoop<Int>>& rings) {
    for (const auto& ring : rings) nodes_.insert(nodes_.end(), ring.begin(), ring.end());
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        boundary_.push_back({id(ring[i]), id(ring[(i + 1) % ring.size()])});
      }
    }
  }

  std::vector<IntLoop<Int>> run() {
    add_diagonals();
    std::vector<std::vector<std::size_t>> faces = trace_faces();
    for (const Edge& diagonal : diagonals_) merge_along(diagonal, faces);
    std::vector<IntLoop<Int>> result;
    for (const auto& face : faces) {
      IntLoop<Int> piece;
      for (const std::size_t node : face) piece.push_back(nodes_[node]);
      if (!piece.empty()) result.push_back(std::move(piece));
    }
    return result;
  }

 private:
  struct Edge {
    std::size_t from;
    std::size_t to;
    bool operator==(const Edge&) const = default;
  };

  std::size_t id(const IntPt<Int>& p) const {
    const auto it = std::lower_bound(nodes_.begin(), nodes_.end(), p);
    return static_cast<std::size_t>(it - nodes_.begin());
  }

  bool crosses(const Edge& e, const Edge& f) const {
    const auto& a = nodes_[e.from];
    const auto& b = nodes_[e.to];
    const auto& c = nodes_[f.from];
    const auto& d = nodes_[f.to];
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }

  bool passes_a_node(const Edge& e) const {
    const auto& a = nodes_[e.from];
    const auto& b = nodes_[e.to];  // a < b, nodes are sorted: inner nodes lie between in the order
    for (std::size_t i = e.from + 1; i < e.to; ++i) {
      if (turn(a, b, nodes_[i]) == 0) return true;
    }
    return false;
  }

  // The even-odd test uses doubled coordinates; the midpoint lies on no edge.
  bool midpoint_is_inside(const Edge& e) const {
    const IntPt<Int> m = nodes_[e.from] + nodes_[e.to];
    bool inside = false;
    for (const Edge& f : boundary_) {
      const IntPt<Int> a = nodes_[f.from] + nodes_[f.from];
      const IntPt<Int> b = nodes_[f.to] + nodes_[f.to];
      if ((a.y <= m.y) == (b.y <= m.y)) continue;
      const int side = turn(a, b, m);
      if (a.y <= m.y ? side > 0 : side < 0) inside = !inside;
    }
    return inside;
  }

  bool is_diagonal(const Edge& e) const {
    const Edge reverse{e.to, e.from};
    for (const Edge& f : boundary_) {
      if (f == e || f == reverse || crosses(e, f)) return false;
    }
    for (const Edge& f : diagonals_) {
      if (crosses(e, f)) return false;
    }
    return !passes_a_node(e) && midpoint_is_inside(e);
  }

  void add_diagonals() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (std::size_t j = i + 1; j < nodes_.size(); ++j) {
        if (is_diagonal({i, j})) diagonals_.push_back({i, j});
      }
    }
  }

  // Classifies the clockwise turn from the direction to `back`: 0 is less than half a turn, 1 half,
  // 2 more, and 3 a full turn.
  int clockwise_class(std::size_t node, std::size_t back, std::size_t p) const {
    const int side = turn(nodes_[node], nodes_[back], nodes_[p]);
    if (side != 0) return side < 0 ? 0 : 2;
    const bool same_side = (nodes_[back] < nodes_[node]) == (nodes_[p] < nodes_[node]);
    return same_side ? 3 : 1;
  }

  bool clockwise_before(std::size_t node, std::size_t back, std::size_t a, std::size_t b) const {
    const int class_a = clockwise_class(node, back, a);
    const int class_b = clockwise_class(node, back, b);
    if (class_a != class_b) return class_a < class_b;
    return turn(nodes_[node], nodes_[a], nodes_[b]) < 0;
  }

  // Returns the faces on the left of directed edges; each walk turns as far left as possible.
  std::vector<std::vector<std::size_t>> trace_faces() const {
    std::vector<Edge> edges = boundary_;
    for (const Edge& d : diagonals_) {
      edges.push_back(d);
      edges.push_back({d.to, d.from});
    }
    std::vector<std::vector<std::size_t>> leaving(nodes_.size());
    for (std::size_t e = 0; e < edges.size(); ++e) leaving[edges[e].from].push_back(e);
    std::vector<bool> done(edges.size(), false);
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t start = 0; start < edges.size(); ++start) {
      std::vector<std::size_t> face;
      for (std::size_t e = start; !done[e];) {
        done[e] = true;
        face.push_back(edges[e].from);
        const auto& out = leaving[edges[e].to];
        e = *std::min_element(out.begin(), out.end(), [&](std::size_t f, std::size_t g) {
          return clockwise_before(edges[e].to, edges[e].from, edges[f].to, edges[g].to);
        });
      }
      if (!face.empty()) faces.push_back(std::move(face));
      if (!faces.empty() && faces.back().size() != 3) {
        throw std::logic_error("a face that is no triangle");
      }
    }
    return faces;
  }

  // Returns the position of `from` if `face` has the edge from -> to, else the size of `face`.
  static std::size_t find_edge(const std::vector<std::size_t>& face, const Edge& e) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] == e.from && face[(i + 1) % face.size()] == e.to) return i;
    }
    return face.size();
  }

  bool is_convex(const std::vector<std::size_t>& face) const {
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (turn(nodes_[face[i]], nodes_[face[(i + 1) % n]], nodes_[face[(i + 2) % n]]) < 0) {
        return false;
      }
    }
    return true;
  }

  void merge_along(const Edge& diagonal, std::vector<std::vector<std::size_t>>& faces) const {
    const Edge reverse{diagonal.to, diagonal.from};
    const auto has = [](const Edge& e) {
      return [e](const std::vector<std::size_t>& f) { return find_edge(f, e) != f.size(); };
    };
    const auto left = std::find_if(faces.begin(), faces.end(), has(diagonal));
    const auto right = std::find_if(faces.begin(), faces.end(), has(reverse));
    if (left == faces.end() || right == faces.end() || left == right) return;
    std::vector<std::size_t> merged = *left;
    std::rotate(merged.begin(),
                merged.begin() + static_cast<std::ptrdiff_t>(find_edge(*left, diagonal)) + 1,
                merged.end());  // now from `to` round to `from`
    const std::size_t at = find_edge(*right, reverse);
    for (std::size_t i = 2; i < right->size(); ++i) {
      merged.push_back((*right)[(at + i) % right->size()]);
    }
    if (!is_convex(merged)) return;
    *left = std::move(merged);
    right->clear();
  }

  std::vector<IntPt<Int>> nodes_;
  std::vector<Edge> boundary_;
  std::vector<Edge> diagonals_;
};

}  // namespace

template <class Int>
std::vector<IntLoop<Int>> convex_pieces(const std::vector<IntLoop<Int>>& rings) {
  return Cutter<Int>(rings).run();
}

template <class Int>
IntLoop<Int> convex_hull(IntLoop<Int> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  IntLoop<Int> hull;
  const auto extend = [&](const IntPt<Int>& p, std::size_t keep) {
    while (hull.size() > keep && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (std::size_t i = 0; i < points.size(); ++i) extend(points[i], 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], lower);
  hull.pop_back();
  return hull;
}

template std::vector<IntLoop<std::int64_t>> convex_pieces(
    const std::vector<IntLoop<std::int64_t>>&);
template std::vector<IntLoop<Int128>> convex_pieces(const std::vector<IntLoop<Int128>>&);
template std::vector<IntLoop<Integer>> convex_pieces(const std::vector<IntLoop<Integer>>&);
template IntLoop<std::int64_t> convex_hull(IntLoop<std::int64_t>);
template IntLoop<Int128> convex_hull(IntLoop<Int128>);
template IntLoop<Integer> convex_hull(IntLoop<Integer>);

}  // namespace minksum::reference

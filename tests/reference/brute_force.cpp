#include "reference/brute_force.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/brute_force_overlay.hpp"
#include "reference/canonical.hpp"
#include "reference/convex_pieces.hpp"
#include "reference/exact.hpp"
#include "reference/scaled.hpp"

namespace minksum::reference {
namespace {

// The point (x / w, y / w) in lowest terms, with w > 0.
template <class Int>
struct Node {
  Int x;
  Int y;
  Int w;
  friend bool operator<(const Node& a, const Node& b) {
    return std::tie(a.x, a.y, a.w) < std::tie(b.x, b.y, b.w);
  }
};

template <class Int>
Int gcd_of(Int a, Int b) {
  if (a < 0) a = -a;
  if (b < 0) b = -b;
  while (b != 0) a = std::exchange(b, Int(a % b));
  return a;
}

/// Computes the union of convex polygons by the definition of its boundary. A piece of an edge is
/// boundary of the union iff no polygon contains the points just right of it.
template <class Int>
class ConvexUnion {
 public:
  explicit ConvexUnion(std::vector<IntLoop<Int>> polygons) : polygons_(std::move(polygons)) {}

  Region run() {
    for (const auto& polygon : polygons_) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        add_free_parts(polygon[i], polygon[(i + 1) % polygon.size()]);
      }
    }
    const std::vector<Piece> pieces = split_at_nodes();
    std::vector<Pt> points;
    for (const auto& node : nodes_) {
      points.push_back({Number(to_integer(node.x), to_integer(node.w)),
                        Number(to_integer(node.y), to_integer(node.w))});
    }
    return link(points, pieces);
  }

 private:
  // A free piece of an edge. `from` and `to` are nodes on the line through `a` along `d`.
  struct Free {
    IntPt<Int> a;
    IntPt<Int> d;
    std::size_t from;
    std::size_t to;
  };

  // Finds the part of the edge a + t d, 0 <= t <= 1, whose points have `polygon` just right of
  // them.
  static bool clip(const IntPt<Int>& a, const IntPt<Int>& d, const IntLoop<Int>& polygon,
                   Interval<Int>& part) {
    part = {{0, 1}, {1, 1}};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const IntPt<Int> f = polygon[(i + 1) % polygon.size()] - polygon[i];
      const Int at_a = cross(f, a - polygon[i]);  // > 0: left of f, inside
      const Int slope = cross(f, d);
      if (slope == 0) {
        const bool same_way = d.x * f.x + d.y * f.y > 0;  // then our right is f's right
        if (at_a < 0 || (at_a == 0 && same_way)) return false;
      } else if (slope > 0) {
        part.low = std::max(part.low, Fraction<Int>{Int(-at_a), slope});
      } else {
        part.high = std::min(part.high, Fraction<Int>{at_a, Int(-slope)});
      }
    }
    return part.low < part.high;
  }

  void add_free_parts(const IntPt<Int>& a, const IntPt<Int>& b) {
    const IntPt<Int> d = b - a;
    std::vector<Interval<Int>> hidden;
    Interval<Int> part;
    for (const auto& polygon : polygons_) {
      if (clip(a, d, polygon, part)) hidden.push_back(part);
    }
    std::sort(hidden.begin(), hidden.end(),
              [](const auto& s, const auto& t) { return s.low < t.low; });
    Fraction<Int> reached{0, 1};
    for (const auto& interval : hidden) {
      if (reached < interval.low) free_.push_back(make_free(a, d, reached, interval.low));
      reached = std::max(reached, interval.high);
    }
    const Fraction<Int> end{1, 1};
    if (reached < end) free_.push_back(make_free(a, d, reached, end));
  }

  Free make_free(const IntPt<Int>& a, const IntPt<Int>& d, const Fraction<Int>& from,
                 const Fraction<Int>& to) {
    return {a, d, node_at(a, d, from), node_at(a, d, to)};
  }

  std::size_t node_at(const IntPt<Int>& a, const IntPt<Int>& d, const Fraction<Int>& t) {
    Node<Int> node{a.x * t.d + d.x * t.n, a.y * t.d + d.y * t.n, t.d};
    const Int divisor = gcd_of(gcd_of(node.x, node.y), node.w);
    node = {Int(node.x / divisor), Int(node.y / divisor), Int(node.w / divisor)};
    const auto [it, is_new] = ids_.try_emplace(node, nodes_.size());
    if (is_new) nodes_.push_back(node);
    return it->second;
  }

  // Returns the position of a node along a line, for comparison among nodes of that line.
  Fraction<Int> along(const IntPt<Int>& d, std::size_t node) const {
    return {d.x * nodes_[node].x + d.y * nodes_[node].y, nodes_[node].w};
  }

  // Two polygons may give the same free piece, and other pieces may end in the middle of one. So
  // all pieces are cut at all nodes, and one of each is kept.
  std::vector<Piece> split_at_nodes() const {
    std::vector<std::pair<std::size_t, std::size_t>> cut;
    for (const Free& piece : free_) {
      const Fraction<Int> low = along(piece.d, piece.from);
      const Fraction<Int> high = along(piece.d, piece.to);
      std::vector<std::pair<Fraction<Int>, std::size_t>> stops;
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node<Int>& node = nodes_[i];
        if (piece.d.x * node.y - piece.d.y * node.x != cross(piece.d, piece.a) * node.w) continue;
        const Fraction<Int> place = along(piece.d, i);
        if (!(place < low) && !(high < place)) stops.emplace_back(place, i);
      }
      std::sort(stops.begin(), stops.end(),
                [](const auto& s, const auto& t) { return s.first < t.first; });
      for (std::size_t i = 1; i < stops.size(); ++i) {
        cut.emplace_back(stops[i - 1].second, stops[i].second);
      }
    }
    std::sort(cut.begin(), cut.end());
    cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
    std::vector<Piece> pieces;
    for (const auto& [from, to] : cut) pieces.push_back({from, to});
    return pieces;
  }

  std::vector<IntLoop<Int>> polygons_;
  std::vector<Free> free_;
  std::vector<Node<Int>> nodes_;
  std::map<Node<Int>, std::size_t> ids_;
};

Loops thin_loops(const Geometry& geometry) {
  Loops loops;
  for (const Polyline& polyline : geometry.polylines) {
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      loops.push_back({to_pt(polyline[i - 1]), to_pt(polyline[i])});
    }
  }
  for (const Point& point : geometry.points) loops.push_back({to_pt(point)});
  return loops;
}

template <class Int>
std::vector<IntLoop<Int>> all_pieces(const Loops& rings, const Loops& thin) {
  auto pieces = convex_pieces(to_int<Int>(rings));
  for (auto& piece : to_int<Int>(thin)) pieces.push_back(std::move(piece));
  return pieces;
}

template <class Int>
Point unscaled(const IntPt<Int>& p, const Integer& scale) {
  return {to_rational(Number(to_integer(p.x), scale)), to_rational(Number(to_integer(p.y), scale))};
}

// Returns the region of the sum, not yet scaled down, and segments and points, which may overlap.
template <class Int>
Geometry sum_on_grid(const Scaled& scaled) {
  const auto pieces_of_p = all_pieces<Int>(scaled.p, scaled.thin_p);
  const auto pieces_of_q = all_pieces<Int>(scaled.q, scaled.thin_q);
  std::vector<IntLoop<Int>> sums;
  Geometry parts;
  for (const auto& a : pieces_of_p) {
    for (const auto& b : pieces_of_q) {
      IntLoop<Int> points;
      for (const auto& u : a) {
        for (const auto& v : b) points.push_back(u + v);
      }
      IntLoop<Int> hull = points.size() == 1 ? points : convex_hull(std::move(points));
      if (hull.size() == 1) {
        parts.points.push_back(unscaled(hull[0], scaled.scale));
      } else if (hull.size() == 2) {
        parts.polylines.push_back(
            {unscaled(hull[0], scaled.scale), unscaled(hull[1], scaled.scale)});
      } else {
        sums.push_back(std::move(hull));
      }
    }
  }
  parts.region = ConvexUnion<Int>(std::move(sums)).run();
  return parts;
}

template <class Int>
Region union_on_grid(const Scaled& scaled) {
  auto pieces = convex_pieces(to_int<Int>(scaled.p));
  for (auto& piece : convex_pieces(to_int<Int>(scaled.q))) pieces.push_back(std::move(piece));
  for (auto& piece : pieces) piece = convex_hull(std::move(piece));
  return ConvexUnion<Int>(std::move(pieces)).run();
}

Region scale_down(const Region& region, const Integer& scale) {
  if (scale == 1) return region;
  std::vector<Loops> polygons = to_loops(region);
  for (Loops& loops : polygons) {
    for (Loop& loop : loops) {
      for (Pt& p : loop) p = {Number(p.x / scale), Number(p.y / scale)};
    }
  }
  return to_region(polygons);
}

// With operands of B bits, sums have B + 1, edge vectors B + 2, and t = n / d has 2B + 6. The x and
// y of a node have 3B + 9. Its position along a line has 4B + 12, and comparing two takes 6B + 18.
constexpr std::size_t compared_bits(std::size_t operand_bits) { return 6 * operand_bits + 18; }

}  // namespace

Region brute_force_sum(const Region& p, const Region& q) {
  return brute_force_sum(Geometry{p, {}, {}}, Geometry{q, {}, {}}).region;
}

Geometry brute_force_sum(const Geometry& p, const Geometry& q) {
  if (p.empty() || q.empty()) return {};
  const Scaled scaled = scale_up(p.region, q.region, thin_loops(p), thin_loops(q));
  const std::size_t need = compared_bits(scaled.bits);
  Geometry parts = need < 64    ? sum_on_grid<std::int64_t>(scaled)
                   : need < 128 ? sum_on_grid<Int128>(scaled)
                                : sum_on_grid<Integer>(scaled);
  parts.region = scale_down(parts.region, scaled.scale);
  return parts.has_thin_parts() ? brute_force_resolve(parts, FillRule::kAutomatic) : parts;
}

Region brute_force_union(const Region& a, const Region& b) {
  if (a.empty() && b.empty()) return {};
  const Scaled scaled = scale_up(a, b);
  const std::size_t need = compared_bits(scaled.bits);
  return scale_down(need < 64    ? union_on_grid<std::int64_t>(scaled)
                    : need < 128 ? union_on_grid<Int128>(scaled)
                                 : union_on_grid<Integer>(scaled),
                    scaled.scale);
}

}  // namespace minksum::reference

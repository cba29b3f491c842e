#include "reference/tight_places.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "reference/canonical.hpp"
#include "reference/convex_pieces.hpp"
#include "reference/exact.hpp"
#include "reference/scaled.hpp"

namespace minksum::reference {
namespace {

struct Line {
  Pt a;
  Pt b;
  friend bool operator<(const Line& s, const Line& t) { return s.a == t.a ? s.b < t.b : s.a < t.a; }
};

// What convex sums leave of the inside, in no order. Lines may be repeated.
struct Rest {
  std::vector<Line> boundary;  // boundary of the union
  std::vector<Line> tight;
  std::vector<Pt> points;  // in no open sum, and isolated on their edge
};

template <class Int>
class ConvexSums {
 public:
  explicit ConvexSums(std::vector<IntLoop<Int>> sums) : sums_(std::move(sums)) {}

  Rest run() {
    std::set<std::pair<IntPt<Int>, IntPt<Int>>> edges;
    for (const auto& sum : sums_) {
      for (std::size_t i = 0; i < sum.size(); ++i) {
        edges.emplace(sum[i], sum[(i + 1) % sum.size()]);
      }
    }
    for (const auto& [a, b] : edges) look_along(a, b - a);
    return std::move(rest_);
  }

 private:
  using F = Fraction<Int>;

  // Finds the part of t for which a + t d is inside a sum. With `beside`, the points just right of
  // a + t d count instead.
  static bool clip(const IntPt<Int>& a, const IntPt<Int>& d, const IntLoop<Int>& sum, bool beside,
                   Interval<Int>& part) {
    part = {{-1, 1}, {2, 1}};
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const IntPt<Int> f = sum[(i + 1) % sum.size()] - sum[i];
      const Int at_a = cross(f, a - sum[i]);
      const Int slope = cross(f, d);
      if (slope == 0) {
        const bool opposite = d.x * f.x + d.y * f.y < 0;  // then our right is f's left
        if (at_a < 0 || (at_a == 0 && !(beside && opposite))) return false;
      } else if (slope > 0) {
        part.low = std::max(part.low, F{Int(-at_a), slope});
      } else {
        part.high = std::min(part.high, F{at_a, Int(-slope)});
      }
    }
    return part.low < part.high;
  }
  std::vector<Interval<Int>> parts(const IntPt<Int>& a, const IntPt<Int>& d, bool beside) const {
    std::vector<Interval<Int>> result;
    Interval<Int> part;
    for (const auto& sum : sums_) {
      if (clip(a, d, sum, beside, part)) result.push_back(part);
    }
    std::sort(result.begin(), result.end(),
              [](const auto& s, const auto& t) { return s.low < t.low; });
    return result;
  }
  // Returns what open intervals leave of 0 <= t <= 1, points included.
  static std::vector<Interval<Int>> left_over(const std::vector<Interval<Int>>& open) {
    std::vector<Interval<Int>> result;
    F reached{0, 1};
    for (const auto& interval : open) {
      const F low = std::min(interval.low, F{1, 1});
      if (!(low < reached)) result.push_back({reached, low});
      reached = std::max(reached, interval.high);
    }
    if (!(F{1, 1} < reached)) result.push_back({reached, {1, 1}});
    return result;
  }

  void look_along(const IntPt<Int>& a, const IntPt<Int>& d) {
    const auto at = [&](const F& t) {
      const Number position(to_integer(t.n), to_integer(t.d));
      return Pt{Number(Number(to_integer(a.x)) + position * Number(to_integer(d.x))),
                Number(Number(to_integer(a.y)) + position * Number(to_integer(d.y)))};
    };
    const auto not_inside = left_over(parts(a, d, false));
    const auto beside = parts(a, d, true);
    const auto bare = left_over(beside);
    for (const auto& gap : not_inside) {
      if (!(gap.low < gap.high)) rest_.points.push_back(at(gap.low));
      for (const auto& hidden : left_over(bare)) {
        const F low = std::max(gap.low, hidden.low);
        const F high = std::min(gap.high, hidden.high);
        if (low < high) rest_.tight.push_back({at(low), at(high)});
      }
    }
    for (const auto& gap : bare) {
      if (gap.low < gap.high) rest_.boundary.push_back({at(gap.low), at(gap.high)});
    }
  }

  std::vector<IntLoop<Int>> sums_;
  Rest rest_;
};

template <class Int>
Rest rest_on_grid(const Scaled& scaled) {
  const auto pieces_of_q = convex_pieces(to_int<Int>(scaled.q));
  std::vector<IntLoop<Int>> sums;
  for (const auto& a : convex_pieces(to_int<Int>(scaled.p))) {
    for (const auto& b : pieces_of_q) {
      IntLoop<Int> points;
      for (const auto& u : a) {
        for (const auto& v : b) points.push_back(u + v);
      }
      sums.push_back(convex_hull(std::move(points)));
    }
  }
  return ConvexSums<Int>(std::move(sums)).run();
}

// Joins lines to polylines.
class PathBuilder {
 public:
  explicit PathBuilder(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      std::set<Pt> stops{line.a, line.b};
      for (const Line& other : lines) {
        for (const Pt& p : shared_points(line, other)) stops.insert(p);
      }
      for (auto next = std::next(stops.begin()); next != stops.end(); ++next) {
        neighbours_[*std::prev(next)].insert(*next);
        neighbours_[*next].insert(*std::prev(next));
      }
    }
  }

  std::vector<Loop> run() {
    std::vector<Loop> paths;
    // Paths start first at nodes that are not inner points of a path. Then only closed paths
    // remain.
    for (const bool plain : {false, true}) {
      for (auto& [start, around] : neighbours_) {
        if (is_plain(start) != plain) continue;
        while (!neighbours_left_[start].empty()) {
          paths.push_back(canonical_path(walk(start), plain));
        }
      }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
  }

 private:
  static std::vector<Pt> shared_points(const Line& s, const Line& t) {
    std::vector<Pt> points;
    for (const Pt& p : {t.a, t.b}) {
      if (on_segment(p, s.a, s.b)) points.push_back(p);
    }
    if (cross_properly(s.a, s.b, t.a, t.b)) {
      const auto area = [](const Pt& a, const Pt& b, const Pt& c) {
        return Number((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
      };
      const Number at_a = area(t.a, t.b, s.a);
      const Number position = at_a / (at_a - area(t.a, t.b, s.b));
      points.push_back(
          {Number(s.a.x + position * (s.b.x - s.a.x)), Number(s.a.y + position * (s.b.y - s.a.y))});
    }
    return points;
  }
  bool is_plain(const Pt& p) {
    if (neighbours_left_.empty()) neighbours_left_ = neighbours_;
    return neighbours_[p].size() == 2;
  }
  Loop walk(const Pt& start) {
    Loop path{start};
    do {
      const Pt from = path.back();
      const Pt to = *neighbours_left_[from].begin();
      neighbours_left_[from].erase(to);
      neighbours_left_[to].erase(from);
      path.push_back(to);
    } while (is_plain(path.back()) && !(path.back() == start));
    return path;
  }
  static Loop canonical_path(Loop path, bool free_start) {
    const bool closed = path.front() == path.back();
    if (closed && free_start) {
      path.pop_back();
      std::rotate(path.begin(), std::min_element(path.begin(), path.end()), path.end());
      path.push_back(path.front());
    }
    Loop corners{path.front()};
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      if (turn(path[i - 1], path[i], path[i + 1]) != 0) corners.push_back(path[i]);
    }
    corners.push_back(path.back());
    const bool turns =
        closed ? corners[corners.size() - 2] < corners[1] : corners.back() < corners.front();
    if (turns) std::reverse(corners.begin(), corners.end());
    return corners;
  }

  std::map<Pt, std::set<Pt>> neighbours_;
  std::map<Pt, std::set<Pt>> neighbours_left_;
};

bool on_any(const Pt& p, const std::vector<Line>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const Line& line) { return on_segment(p, line.a, line.b); });
}

template <class Value>
void make_unique(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(),
                           [](const Value& a, const Value& b) { return !(a < b) && !(b < a); }),
               values.end());
}

Point scaled_point(const Pt& p, const Integer& scale) {
  return {to_rational(Number(p.x / scale)), to_rational(Number(p.y / scale))};
}

}  // namespace

Geometry brute_force_tight_places(const Region& p, const Region& q) {
  Geometry result;
  if (p.empty() || q.empty()) return result;
  const Scaled scaled = scale_up(p, q);
  // With operands of B bits, sums have B + 1, t = n / d has 2B + 6, and comparing two such t takes
  // 4B + 12.
  const std::size_t need = 4 * scaled.bits + 12;
  Rest rest = need < 64    ? rest_on_grid<std::int64_t>(scaled)
              : need < 128 ? rest_on_grid<Int128>(scaled)
                           : rest_on_grid<Integer>(scaled);
  make_unique(rest.tight);
  make_unique(rest.points);
  for (const Loop& path : PathBuilder(rest.tight).run()) {
    Polyline& line = result.polylines.emplace_back();
    for (const Pt& point : path) line.push_back(scaled_point(point, scaled.scale));
  }
  for (const Pt& point : rest.points) {
    if (on_any(point, rest.boundary) || on_any(point, rest.tight)) continue;
    result.points.push_back(scaled_point(point, scaled.scale));
  }
  return result;
}

}  // namespace minksum::reference

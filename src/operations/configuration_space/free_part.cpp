#include "operations/configuration_space/free_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace minksum {
namespace {

constexpr double kHuge = std::numeric_limits<double>::infinity();

Point along(const Point& a, const Point& b, const Rational& t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

LooseBox loose_box(const RoundedPoint& a, const RoundedPoint& b) {
  return {std::nextafter(std::min(a.x, b.x), -kHuge), std::nextafter(std::min(a.y, b.y), -kHuge),
          std::nextafter(std::max(a.x, b.x), kHuge), std::nextafter(std::max(a.y, b.y), kHuge)};
}

}  // namespace

FreePart::FreePart(Region polygon, const Options& options)
    : region_(std::move(polygon)), locator_({region_, {}, {}}, part_of(options)) {
  Cancellation cancellation(options, Stage::kSearch);
  for (const std::size_t ring : region_.rings_of(0)) {
    const auto index = static_cast<std::uint32_t>(ring_begin_.size());
    ring_begin_.push_back(static_cast<std::uint32_t>(points_.size()));
    for (const std::size_t v : region_.vertices_of(ring)) {
      points_.emplace_back(region_.point(v));
      cancellation.check(2 * work_of(points_.back().exact));
      ring_of_.push_back(index);
    }
  }
  ring_begin_.push_back(static_cast<std::uint32_t>(points_.size()));
  box_ = loose_box(points_[0], points_[0]);
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    const LooseBox edge = loose_box(points_[v], points_[next(v)]);
    edge_boxes_.push_back(edge);
    box_.add(edge);
  }
}

std::uint32_t FreePart::next(std::uint32_t vertex) const {
  const std::uint32_t ring = ring_of_[vertex];
  return vertex + 1 == ring_begin_[ring + 1] ? ring_begin_[ring] : vertex + 1;
}

std::uint32_t FreePart::previous(std::uint32_t vertex) const {
  const std::uint32_t ring = ring_of_[vertex];
  return (vertex == ring_begin_[ring] ? ring_begin_[ring + 1] : vertex) - 1;
}

void FreePart::add_hits(std::uint32_t edge, const Point& a, const Point& d,
                        std::vector<Hit>& found) const {
  const Point from = minus(points_[edge].exact, a);
  const Point to = minus(points_[next(edge)].exact, a);
  const Rational left_from = cross(d, from);
  const Rational left_to = cross(d, to);
  const int sides = left_from.sign() * left_to.sign();
  if (sides > 0) return;
  const Rational one(1);
  if (left_from.sign() == 0 && left_to.sign() == 0) {
    const Rational whole = dot(d, d);
    Rational t = dot(from, d) / whole;
    Rational u = dot(to, d) / whole;
    if (u < t) std::swap(t, u);
    if (u.sign() < 0 || t > one) return;
    found.push_back({std::max(t, Rational(0)), edge});
    found.push_back({std::min(u, one), edge});
    return;
  }
  const Point e = minus(to, from);
  const Rational t = cross(from, e) / cross(d, e);
  if (t.sign() >= 0 && t <= one) found.push_back({t, edge});
}

std::vector<FreePart::Hit> FreePart::hits(const Point& a, const Point& b, bool* crosses,
                                          Cancellation& cancellation) const {
  const RoundedPoint begin(a);
  const RoundedPoint goal(b);
  const LooseBox box = loose_box(begin, goal);
  const auto is_at = [](const RoundedPoint& p, const RoundedPoint& end) {
    return p.x == end.x && p.y == end.y && p.exact == end.exact;
  };
  const Point d = minus(b, a);
  std::vector<Hit> found;
  for (std::uint32_t edge = 0; edge < points_.size(); ++edge) {
    cancellation.check();
    if (!edge_boxes_[edge].meets(box)) continue;
    const RoundedPoint& first = points_[edge];
    const RoundedPoint& second = points_[next(edge)];
    cancellation.check(8 * work_of(first.exact));
    const int from = turn(begin, goal, first);
    const int to = turn(begin, goal, second);
    if (from * to > 0) continue;
    if (from * to < 0 && crosses != nullptr) {
      *crosses = turn(first, second, begin) * turn(first, second, goal) < 0;
      if (*crosses) return found;
    }
    // If one end of an edge is off the line, the other end is the only possible hit. Where it is an
    // end of the segment, no long numbers are needed.
    if ((from == 0) != (to == 0)) {
      const RoundedPoint& on_line = from == 0 ? first : second;
      if (is_at(on_line, begin)) {
        found.push_back({Rational(0), edge});
        continue;
      }
      if (is_at(on_line, goal)) {
        found.push_back({Rational(1), edge});
        continue;
      }
    }
    add_hits(edge, a, d, found);
  }
  std::stable_sort(found.begin(), found.end(), [&](const Hit& x, const Hit& y) {
    cancellation.check(work_of_product(x.t.bits()));
    return x.t < y.t;
  });
  return found;
}

bool FreePart::meets(const Point& a, const Point& b, Location open_side,
                     Cancellation& cancellation) const {
  if (a == b) return locate(a) == open_side;
  // Between two hits the segment is wholly inside or outside. Hits are on the boundary.
  const Rational half(1, 2);
  Rational last;
  const auto found_up_to = [&](const Rational& t) {
    cancellation.check(64 * work_of_product(t.bits()));
    if (t == last) return false;
    const bool is_there = locate(along(a, b, (last + t) * half)) == open_side;
    last = t;
    return is_there;
  };
  // A crossed edge has the inside on one of its sides and the outside on the other.
  bool crosses = false;
  const std::vector<Hit> found = hits(a, b, &crosses, cancellation);
  if (crosses) return true;
  for (const Hit& hit : found) {
    if (found_up_to(hit.t)) return true;
  }
  return found_up_to(Rational(1));
}

/// Tells whether a point is on the side of a ring that is not free: outside of it, or in a hole.
bool FreePart::is_beyond(std::uint32_t ring, const Point& point, const Options& options) const {
  Polygon alone;
  for (std::uint32_t v = ring_begin_[ring]; v < ring_begin_[ring + 1]; ++v) {
    alone.outer.push_back(points_[v].exact);
  }
  const Location location = PointLocator({Region(alone), {}, {}}, part_of(options)).locate(point);
  return location == (ring == 0 ? Location::kOutside : Location::kInside);
}

namespace {

double length_of(const Point& from, const std::vector<Point>& path, const Point& to) {
  double length = 0;
  double x = from.x.to_double();
  double y = from.y.to_double();
  const auto go = [&](const Point& point) {
    const double px = point.x.to_double();
    const double py = point.y.to_double();
    length += std::hypot(px - x, py - y);
    x = px;
    y = py;
  };
  for (const Point& point : path) go(point);
  go(to);
  return length;
}

}  // namespace

/// Appends the vertices between two hits of one ring, the shorter way round, and the second hit.
void FreePart::go_round(const Hit& from, const Point& a, const Hit& to, const Point& b,
                        std::vector<Point>& path) const {
  std::vector<Point> forward;
  std::vector<Point> back;
  const bool same = from.edge == to.edge;
  const bool ahead =
      same &&
      dot(minus(b, a), minus(points_[next(from.edge)].exact, points_[from.edge].exact)).sign() >= 0;
  if (!ahead) {
    std::uint32_t v = from.edge;
    do {
      v = next(v);
      forward.push_back(points_[v].exact);
    } while (v != to.edge);
  }
  if (!same || ahead) {
    const std::uint32_t last = next(to.edge);
    std::uint32_t v = from.edge;
    for (;; v = previous(v)) {
      back.push_back(points_[v].exact);
      if (v == last) break;
    }
  }
  const auto& shorter = length_of(a, forward, b) <= length_of(a, back, b) ? forward : back;
  path.insert(path.end(), shorter.begin(), shorter.end());
  path.push_back(b);
}

std::vector<Point> FreePart::walk(const Point& a, const Point& b,
                                  Cancellation& cancellation) const {
  const std::vector<Hit> found = hits(a, b, nullptr, cancellation);
  const Rational half(1, 2);
  std::vector<Point> path{a};
  std::size_t i = 0;
  while (i < found.size()) {
    const Hit& hit = found[i];
    cancellation.check(64 * work_of_product(hit.t.bits()));
    std::size_t after = i;  // the next hit that lies farther on
    while (after < found.size() && found[after].t == hit.t) ++after;
    const Rational end = after < found.size() ? found[after].t : Rational(1);
    const Point middle = along(a, b, (hit.t + end) * half);
    if (hit.t == end || contains(middle)) {
      i = after;
      continue;
    }
    // This finds the ring by which the segment leaves, and the last hit with it. From there on the
    // segment is on the ring's free side, so each ring is gone around once at most.
    while (i < after && !is_beyond(ring_of_[found[i].edge], middle, cancellation.options())) {
      ++i;
    }
    std::size_t last = found.size();
    for (std::size_t k = found.size(); i < after && k-- > after;) {
      if (ring_of_[found[k].edge] == ring_of_[found[i].edge]) {
        last = k;
        break;
      }
    }
    if (last == found.size()) {
      throw Error(ErrorCode::kInternal, "a way leaves a free part for good", {}, "reach");
    }
    const Point leave = along(a, b, found[i].t);
    path.push_back(leave);
    go_round(found[i], leave, found[last], along(a, b, found[last].t), path);
    while (last > 0 && found[last - 1].t == found[last].t) --last;
    i = last;
  }
  path.push_back(b);
  path.erase(std::unique(path.begin(), path.end()), path.end());
  return path;
}

std::vector<Point> FreePart::shortened(const std::vector<Point>& path,
                                       Cancellation& cancellation) const {
  std::vector<Point> kept{path.front()};
  const std::size_t end = path.size() - 1;
  for (std::size_t i = 0; i < end;) {
    std::size_t seen = i + 1;
    std::size_t step = end - i;
    if (step > 1 && sees(path[i], path[end], cancellation)) {
      seen = end;
    } else {
      for (step = 2; i + step < end && sees(path[i], path[i + step], cancellation); step *= 2) {
        seen = i + step;
      }
      std::size_t hidden = std::min(i + step, end);
      while (hidden - seen > 1) {
        const std::size_t middle = seen + (hidden - seen) / 2;
        (sees(path[i], path[middle], cancellation) ? seen : hidden) = middle;
      }
    }
    kept.push_back(path[seen]);
    i = seen;
  }
  return kept;
}

std::vector<Point> FreePart::way(const Point& a, const Point& b, Cancellation& cancellation) const {
  if (a == b) return {a};
  std::vector<Point> path = walk(a, b, cancellation);
  // Each end is the start once: a corner skipped from one side may be in the way of the other.
  for (int i = 0; i < 2; ++i) {
    path = shortened(path, cancellation);
    std::reverse(path.begin(), path.end());
  }
  return path;
}

}  // namespace minksum

#include "round/choose_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "number/sign.hpp"
#include "round/orientation.hpp"

namespace minksum {
namespace {

/// A cross product in doubles, with a bound on its error.
struct Estimate {
  double value = 0;
  double error = 0;
};

class SideChooser {
 public:
  SideChooser(const Region& region, RoundingSide side, const Target& target,
              RoundedVertices& vertices)
      : region_(region), side_(side), target_(target), vertices_(vertices) {}

  bool run() {
    for (const std::size_t polygon : region_.polygons()) {
      bool is_hole = false;
      for (const std::size_t ring : region_.rings_of(polygon)) {
        const bool interior_left = counter_clockwise(region_, ring) != is_hole;
        forward_ = interior_left == (side_ == RoundingSide::kOutside);
        ring_ = region_.vertices_of(ring);
        if (!choose_ring()) return false;
        is_hole = true;
      }
    }
    return true;
  }

 private:
  /// A vertex in the order in which the set to be enclosed is on the left.
  [[nodiscard]] std::size_t vertex(std::size_t i) const {
    const std::size_t n = ring_.size();
    i %= n;
    return ring_.front() + (forward_ ? i : n - 1 - i);
  }

  /// Vertices one after the other, each with regard to the place chosen before it; the edge before
  /// the first vertex is judged with the last.
  bool choose_ring() {
    const std::size_t n = ring_.size();
    // Exact vertices are the best to start at: they have no choice.
    std::size_t start = 0;
    while (start < n && vertices_[vertex(start)].moved()) ++start;
    if (start == n) start = 0;
    for (std::size_t i = start; i < start + n; ++i) {
      if (!choose(vertex(i + n - 1), vertex(i), vertex(i + 1), i != start, i + 1 == start + n)) {
        return false;
      }
    }
    return true;
  }

  bool choose(std::size_t before, std::size_t at, std::size_t after, bool before_chosen,
              bool after_chosen) {
    const RoundedVertex nearest = vertices_[at];
    if (!nearest.moved()) {
      return (!before_chosen || edge_allowed(before, at)) &&
             (!after_chosen || edge_allowed(at, after));
    }
    const auto allowed = [&] {
      return moves_right(before, at, at) && moves_right(at, after, at) &&
             (!before_chosen || edge_allowed(before, at)) &&
             (!after_chosen || edge_allowed(at, after));
    };
    if (allowed()) return true;
    for (const RoundedVertex& corner : other_corners(nearest, at)) {
      const bool finite = std::isfinite(corner.x.value) && std::isfinite(corner.y.value);
      if (!finite && !target_.is_decimal()) continue;
      vertices_[at] = corner;
      if (allowed()) return true;
    }
    return false;
  }

  /// The other corners of the cell that a vertex is in, the nearer ones first.
  [[nodiscard]] std::vector<RoundedVertex> other_corners(const RoundedVertex& nearest,
                                                         std::size_t v) const {
    std::vector<RoundedVertex> result;
    const auto other_x = [&](RoundedVertex c) {
      const bool up = c.off_x > 0;
      c.x = next_place(c.x, up, target_);
      c.off_x = off(region_.exact_x(v), c.x);
      return c;
    };
    const auto other_y = [&](RoundedVertex c) {
      const bool up = c.off_y > 0;
      c.y = next_place(c.y, up, target_);
      c.off_y = off(region_.exact_y(v), c.y);
      return c;
    };
    if (nearest.off_x != 0) result.push_back(other_x(nearest));
    if (nearest.off_y != 0) result.push_back(other_y(nearest));
    if (result.size() == 2) {
      if (std::abs(nearest.off_x) < std::abs(nearest.off_y)) std::swap(result[0], result[1]);
      result.push_back(other_y(other_x(nearest)));
    }
    return result;
  }
  [[nodiscard]] double off(const Rational& exact, const Place& place) const {
    if (!target_.is_decimal() && !std::isfinite(place.value)) return 0;
    const Rational difference = (exact - value_of(place, target_)) / target_.unit();
    const double size = std::max(std::abs(difference.to_double()),
                                 std::numeric_limits<double>::denorm_min());
    return difference.sign() < 0 ? -size : size;
  }

  /// All four conditions on an edge.
  bool edge_allowed(std::size_t p, std::size_t v) const {
    return moves_right(p, v, p) && moves_right(p, v, v) && moved_right(p, v, p) &&
           moved_right(p, v, v);
  }
  /// Whether `end` moves to the right of the edge from p to v, or along it, at first.
  [[nodiscard]] bool moves_right(std::size_t p, std::size_t v, std::size_t end) const {
    return sign(p, v, end, false) != kPositive;
  }
  /// The same at last.
  [[nodiscard]] bool moved_right(std::size_t p, std::size_t v, std::size_t end) const {
    return sign(p, v, end, true) != kPositive;
  }

  /// Sign of e × d: e is the edge from p to v, exact or rounded; d the move of `end`.
  [[nodiscard]] Sign sign(std::size_t p, std::size_t v, std::size_t end, bool rounded) const {
    if (!vertices_[end].moved()) return kZero;
    const Estimate estimate = estimated(vertices_[p], vertices_[v], vertices_[end], rounded);
    if (estimate.value > estimate.error) return kPositive;
    if (estimate.value < -estimate.error) return kNegative;
    return exact_sign(p, v, end, rounded);
  }

  /// Places are exact here, and offsets have a relative error of 2^-53. So a component of an edge is
  /// off by less than 2^-51 of its terms' sizes, and the product by less than 2^-49 of its own,
  /// unless numbers are so small that they lose digits.
  static Estimate estimated(const RoundedVertex& p, const RoundedVertex& v,
                            const RoundedVertex& end, bool rounded) {
    constexpr double kLargestInteger = 0x1p53;
    constexpr double kSmallestOffset = 0x1p-900;
    for (const Place* place : {&p.x, &p.y, &v.x, &v.y}) {
      if (!place->integer.is_zero() && !(std::abs(place->value) < kLargestInteger)) {
        return {0, HUGE_VAL};
      }
    }
    for (const double off : {p.off_x, p.off_y, v.off_x, v.off_y}) {
      if (off != 0 && std::abs(off) < kSmallestOffset) return {0, HUGE_VAL};
    }
    double ex = v.x.value - p.x.value;
    double ey = v.y.value - p.y.value;
    double size_x = std::abs(ex);
    double size_y = std::abs(ey);
    if (!rounded) {
      ex += v.off_x - p.off_x;
      ey += v.off_y - p.off_y;
      size_x += std::abs(v.off_x) + std::abs(p.off_x);
      size_y += std::abs(v.off_y) + std::abs(p.off_y);
    }
    // The move is the offset turned round.
    const double value = ey * end.off_x - ex * end.off_y;
    const double size = size_x * std::abs(end.off_y) + size_y * std::abs(end.off_x);
    return {value, size * 0x1p-48 + std::numeric_limits<double>::min()};
  }

  [[nodiscard]] Sign exact_sign(std::size_t p, std::size_t v, std::size_t end,
                                bool rounded) const {
    const auto place = [&](std::size_t i) {
      return Point{value_of(vertices_[i].x, target_), value_of(vertices_[i].y, target_)};
    };
    const Point from = rounded ? place(p) : region_.point(p);
    const Point to = rounded ? place(v) : region_.point(v);
    const Point start = region_.point(end);
    const Point stop = place(end);
    const Rational cross = (to.x - from.x) * (stop.y - start.y) -
                           (to.y - from.y) * (stop.x - start.x);
    return static_cast<Sign>(cross.sign());
  }

  const Region& region_;
  RoundingSide side_;
  Target target_;
  RoundedVertices& vertices_;
  IndexRange ring_{0, 0};
  bool forward_ = true;
};

}  // namespace

bool choose_side(const Region& region, RoundingSide side, const Target& target,
                 RoundedVertices& vertices) {
  return SideChooser(region, side, target, vertices).run();
}

}  // namespace minksum

#include "rounding/choose_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "exact/formulas.hpp"
#include "exact/sign.hpp"
#include "region/point_arithmetic.hpp"
#include "rounding/orientation.hpp"

namespace minksum {
namespace {

/// Offsets smaller than this may have lost digits.
constexpr double kSmallestOffset = 0x1p-900;

/// A vertex and the place to which it goes.
struct Corner {
  std::size_t source = 0;
  RoundedVertex to;
};
/// The one or two places to which a vertex goes.
using Choice = std::vector<Corner>;

class RingChooser {
 public:
  RingChooser(const Region& region, const Target& target, const RoundedVertices& nearest,
              double step, std::size_t ring, bool forward, Cancellation& cancellation)
      : cancellation_(cancellation),
        region_(region),
        target_(target),
        nearest_(nearest),
        step_(step),
        ring_(region.vertices_of(ring)),
        forward_(forward) {}

  bool run() {
    const std::size_t n = ring_.size();
    // It is best to start at an exact vertex, because it has no choice.
    std::size_t start = 0;
    while (start < n && nearest_[vertex(start)].moved()) ++start;
    if (start == n) start = 0;
    for (std::size_t i = start; i < start + n; ++i) {
      before_ = vertex(i + n - 1);
      after_ = vertex(i + 1);
      is_last_ = i + 1 == start + n;
      if (!choose(vertex(i))) return false;
    }
    return true;
  }

  void add_ring(Region& result) {
    if (!forward_) std::reverse(corners_.begin(), corners_.end());
    result.begin_ring();
    for (const Corner& corner : corners_) add_vertex(result, corner.to.x, corner.to.y, target_);
  }
  [[nodiscard]] double largest_move() const { return largest_move_; }

 private:
  /// Returns a vertex in the order in which the set to be enclosed is on the left.
  [[nodiscard]] std::size_t vertex(std::size_t i) const {
    const std::size_t n = ring_.size();
    i %= n;
    return ring_.front() + (forward_ ? i : n - 1 - i);
  }
  [[nodiscard]] Corner nearest_of(std::size_t v) const { return {v, nearest_[v]}; }

  /// Chooses the places of a vertex, with regard to those of the vertices before it.
  bool choose(std::size_t v) {
    if (try_choice({nearest_of(v)})) return true;
    if (!nearest_[v].moved()) return false;
    const std::vector<Corner> corners = corners_of_cell(v);
    for (const Corner& corner : corners) {
      if (try_choice({corner})) return true;
    }
    const Vec<double> in = edge(nearest_of(before_), nearest_of(v));
    const Vec<double> out = edge(nearest_of(v), nearest_of(after_));
    if (cross(in, out) < 0) return go_up_notch(v, in, out);
    for (const Corner& first : corners) {
      for (const Corner& second : corners) {
        if (try_choice({first, second})) return true;
      }
    }
    return false;
  }

  /// Takes the choice if it is allowed, and returns whether it is.
  bool try_choice(const Choice& choice) {
    cancellation_.check(32);
    const std::size_t v = choice.front().source;
    for (const Corner& corner : choice) {
      const bool finite = std::isfinite(corner.to.x.value) && std::isfinite(corner.to.y.value);
      if (!finite && !target_.is_decimal()) return false;
    }
    if (!moves_right(nearest_of(before_), choice.front(), choice.front())) return false;
    if (!moves_right(choice.back(), nearest_of(after_), choice.back())) return false;
    if (!corners_.empty() && !edge_allowed(corners_.back(), choice.front())) return false;
    if (choice.size() == 2 && !edge_allowed(choice.front(), choice.back())) return false;
    if (is_last_ &&
        !edge_allowed(choice.back(), corners_.empty() ? choice.front() : corners_.front())) {
      return false;
    }
    const double move = distance_moved(choice, v);
    if (!within_cell_ && move > rounded_up(step_ * std::sqrt(2.0))) return false;
    largest_move_ = std::max(largest_move_, move);
    corners_.insert(corners_.end(), choice.begin(), choice.end());
    return true;
  }

  // -- Candidates --------------------------------------------------------------------------------
  /// Returns the corners of the cell around a vertex, the nearest first. If the vertex is on a side
  /// of the cell, there are two.
  [[nodiscard]] std::vector<Corner> corners_of_cell(std::size_t v) const {
    const RoundedVertex& nearest = nearest_[v];
    std::vector<Corner> result{nearest_of(v)};
    const auto add = [&](bool other_x, bool other_y) {
      Corner corner = nearest_of(v);
      if (other_x) corner.to.x = next_place(nearest.x, nearest.off_x > 0, target_);
      if (other_y) corner.to.y = next_place(nearest.y, nearest.off_y > 0, target_);
      set_offsets(corner);
      result.push_back(corner);
    };
    if (nearest.off_x != 0) add(true, false);
    if (nearest.off_y != 0) add(false, true);
    if (result.size() == 3) add(true, true);
    return result;
  }

  /// Tries places along the middle of the notch at a reflex vertex, farther and farther away. A
  /// rough direction is good enough, because every place is tested exactly.
  bool go_up_notch(std::size_t v, const Vec<double>& in, const Vec<double>& out) {
    const RoundedVertex& nearest = nearest_[v];
    const Vec<double> cell{size_of_cell(nearest.x), size_of_cell(nearest.y)};
    // The larger side measures both directions. With cells of unlike sides, the notch would
    // otherwise look narrower than it is.
    const double side = std::max(cell.x, cell.y);
    const auto unit = [](double x, double y) {
      const double length = length_of(x, y);
      return Vec<double>{x / length, y / length};
    };
    const Vec<double> back = unit(-in.x, -in.y);
    const Vec<double> ahead = unit(out.x, out.y);
    const double length = length_of(back.x + ahead.x, back.y + ahead.y);
    const Vec<double> way{(back.x + ahead.x) / length, (back.y + ahead.y) / length};
    if (!std::isfinite(way.x) || !std::isfinite(way.y)) return false;
    constexpr double kFarthest = 100;
    constexpr double kStretch = 1.25;
    within_cell_ = false;
    bool found = false;
    for (double far = 0.5; far < kFarthest && !found; far *= kStretch) {
      const double x = std::floor((nearest.off_x + far * side * way.x) / cell.x);
      const double y = std::floor((nearest.off_y + far * side * way.y) / cell.y);
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        Corner corner = nearest_of(v);
        corner.to.x = shifted_place(nearest.x, x + dx, cell.x, target_);
        corner.to.y = shifted_place(nearest.y, y + dy, cell.y, target_);
        set_offsets(corner);
        if (try_choice({corner})) {
          found = true;
          break;
        }
      }
    }
    within_cell_ = true;
    return found;
  }

  [[nodiscard]] double size_of_cell(const RoundedCoordinate& place) const {
    return target_.is_decimal() ? 1 : next_place(place, true, target_).value - place.value;
  }
  /// Sets how far the exact vertex is from its place. No place is closer to the vertex than the
  /// nearest one. So nothing cancels here, and the offset has a relative error below 2^-50.
  void set_offsets(Corner& corner) const {
    const RoundedVertex& nearest = nearest_[corner.source];
    const auto difference = [&](const RoundedCoordinate& from, const RoundedCoordinate& to) {
      return target_.is_decimal()
                 ? static_cast<double>(static_cast<std::int64_t>(from.integer - to.integer))
                 : from.value - to.value;
    };
    corner.to.off_x = nearest.off_x + difference(nearest.x, corner.to.x);
    corner.to.off_y = nearest.off_y + difference(nearest.y, corner.to.y);
    if (!target_.is_decimal()) {
      make_sure(
          nearest.off_x, [&] { return region_.exact_x(corner.source); }, corner.to.x,
          corner.to.off_x);
      make_sure(
          nearest.off_y, [&] { return region_.exact_y(corner.source); }, corner.to.y,
          corner.to.off_y);
    }
  }
  /// Mends an offset next to 0, where a nearest offset stands for anything smaller than all
  /// doubles.
  template <class Exact>
  static void make_sure(double nearest_off, Exact exact, const RoundedCoordinate& place,
                        double& off) {
    if (nearest_off == 0 || std::abs(off) >= kSmallestOffset || !std::isfinite(place.value)) return;
    const int sign = (exact() - Rational(place.value)).sign();
    off = sign * std::max(std::abs(off), std::numeric_limits<double>::denorm_min());
  }

  // -- Judging them ------------------------------------------------------------------------------
  /// Tests all four conditions on an edge.
  [[nodiscard]] bool edge_allowed(const Corner& p, const Corner& v) const {
    return moves_right(p, v, p) && moves_right(p, v, v) && moved_right(p, v, p) &&
           moved_right(p, v, v);
  }
  /// Tells whether `end` starts by moving to the right of the edge from p to v, or along it.
  [[nodiscard]] bool moves_right(const Corner& p, const Corner& v, const Corner& end) const {
    return p.source == v.source || sign(p, v, end, false) != kPositive;
  }
  /// Tells whether `end` finishes by moving so.
  [[nodiscard]] bool moved_right(const Corner& p, const Corner& v, const Corner& end) const {
    return sign(p, v, end, true) != kPositive;
  }

  /// Returns the sign of e × d, where e is the edge from p to v, exact or rounded, and d the move
  /// of `end`.
  [[nodiscard]] Sign sign(const Corner& p, const Corner& v, const Corner& end, bool rounded) const {
    if (!end.to.moved()) return kZero;
    const double bound = error_bound(p.to, v.to, end.to, rounded);
    const Vec<double> e =
        rounded ? Vec<double>{v.to.x.value - p.to.x.value, v.to.y.value - p.to.y.value}
                : edge(p, v);
    // The move is the negative offset.
    const double value = e.y * end.to.off_x - e.x * end.to.off_y;
    if (value > bound) return kPositive;
    if (value < -bound) return kNegative;
    return exact_sign(p, v, end, rounded);
  }

  /// Returns the exact edge, but for rounding; its ends have different sources.
  [[nodiscard]] static Vec<double> edge(const Corner& p, const Corner& v) {
    return {(v.to.x.value - p.to.x.value) + (v.to.off_x - p.to.off_x),
            (v.to.y.value - p.to.y.value) + (v.to.off_y - p.to.off_y)};
  }

  /// Bounds the error of `sign`. Places are exact here, and offsets have a relative error of 2^-50.
  /// So a component of an edge is off by less than 2^-49 of its terms' sizes. The product is off by
  /// less than 2^-47 of its own size, unless numbers are so small that they lose digits.
  static double error_bound(const RoundedVertex& p, const RoundedVertex& v,
                            const RoundedVertex& end, bool rounded) {
    constexpr double kLargestInteger = 0x1p53;
    for (const RoundedCoordinate* place : {&p.x, &p.y, &v.x, &v.y}) {
      if (!place->integer.is_zero() && !(std::abs(place->value) < kLargestInteger)) return HUGE_VAL;
    }
    for (const double off : {p.off_x, p.off_y, v.off_x, v.off_y}) {
      if (off != 0 && std::abs(off) < kSmallestOffset) return HUGE_VAL;
    }
    double size_x = std::abs(v.x.value - p.x.value);
    double size_y = std::abs(v.y.value - p.y.value);
    if (!rounded) {
      size_x += std::abs(v.off_x) + std::abs(p.off_x);
      size_y += std::abs(v.off_y) + std::abs(p.off_y);
    }
    const double size = size_x * std::abs(end.off_y) + size_y * std::abs(end.off_x);
    return size * 0x1p-46 + std::numeric_limits<double>::min();
  }

  [[nodiscard]] Sign exact_sign(const Corner& p, const Corner& v, const Corner& end,
                                bool rounded) const {
    const auto place = [&](const Corner& corner) {
      return Point{value_of(corner.to.x, target_), value_of(corner.to.y, target_)};
    };
    const Point from = rounded ? place(p) : region_.point(p.source);
    const Point to = rounded ? place(v) : region_.point(v.source);
    cancellation_.check(16 * work_of(to));
    const Point start = region_.point(end.source);
    const Point stop = place(end);
    return static_cast<Sign>(cross(minus(to, from), minus(stop, start)).sign());
  }

  /// Returns an upper bound on the distance of a vertex's places from the vertex's edges.
  [[nodiscard]] double distance_moved(const Choice& choice, std::size_t v) const {
    double largest = 0;
    for (const Corner& corner : choice) {
      if (!corner.to.moved()) continue;
      double move = rounded_up(length_of(corner.to.off_x, corner.to.off_y));
      if (!within_cell_) {
        move = std::min(move, std::max(distance(corner, edge(nearest_of(v), nearest_of(before_))),
                                       distance(corner, edge(nearest_of(v), nearest_of(after_)))));
      }
      largest = std::max(largest, move);
    }
    return largest;
  }
  /// Returns the distance of a place from its vertex's edge e, rounded up. The nearest point of e
  /// is computed in doubles: any point of the edge gives an upper bound.
  [[nodiscard]] static double distance(const Corner& corner, const Vec<double>& e) {
    const double x = -corner.to.off_x;
    const double y = -corner.to.off_y;
    double part = (x * e.x + y * e.y) / (e.x * e.x + e.y * e.y);
    if (!(part > 0)) part = 0;
    if (part > 1) part = 1;
    const double along_x = part * e.x;
    const double along_y = part * e.y;
    const double error =
        (std::abs(x) + std::abs(y) + std::abs(along_x) + std::abs(along_y)) * 0x1p-46;
    return rounded_up(length_of(x - along_x, y - along_y) + error);
  }

  Cancellation& cancellation_;
  const Region& region_;
  const Target& target_;
  const RoundedVertices& nearest_;
  double step_;
  IndexRange ring_;
  bool forward_;
  std::size_t before_ = 0;
  std::size_t after_ = 0;
  bool is_last_ = false;
  bool within_cell_ = true;  ///< candidates are corners of the vertex's own cell
  std::vector<Corner> corners_;
  double largest_move_ = 0;
};

}  // namespace

std::optional<Sided> choose_side(const Region& region, RoundingSide side, const Target& target,
                                 const RoundedVertices& nearest, double step,
                                 Cancellation& cancellation) {
  Sided result;
  for (const std::size_t polygon : region.polygons()) {
    result.region.begin_polygon();
    bool is_hole = false;
    for (const std::size_t ring : region.rings_of(polygon)) {
      const bool interior_left = counter_clockwise(region, ring, cancellation) != is_hole;
      RingChooser chooser(region, target, nearest, step, ring,
                          interior_left == (side == RoundingSide::kOutside), cancellation);
      if (!chooser.run()) return std::nullopt;
      chooser.add_ring(result.region);
      result.largest_move = std::max(result.largest_move, chooser.largest_move());
      is_hole = true;
    }
  }
  return result;
}

}  // namespace minksum

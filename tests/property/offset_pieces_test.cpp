// Tests offsets with all joins and caps by their definition: an offset is the set, the strips
// beside edges, and the pieces at corners and ends. The test is in floating point, and only for
// points that are clearly inside or outside of every piece.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "minksum/resolve.hpp"
#include "property/offsets.hpp"
#include "reference/membership.hpp"

namespace minksum {
namespace {

using namespace test;
using Real = long double;

struct Vec {
  Real x;
  Real y;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
Vec operator*(Real f, Vec a) { return {f * a.x, f * a.y}; }
Real cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
Real length(Vec a) { return std::hypot(a.x, a.y); }
Vec to_vec(const Point& p) { return {p.x.to_double(), p.y.to_double()}; }

/// Returns how far x is inside a convex polygon. Outside the result is negative, and at most the
/// distance of x in size.
Real depth(const std::vector<Vec>& polygon, Vec x) {
  Real least = HUGE_VALL;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (length(b - a) == 0) continue;
    least = std::min(least, cross(b - a, x - a) / length(b - a));
  }
  return least;
}

/// Keeps all pieces of one offset, and tells how deep a point is in the deepest of them.
class Pieces {
 public:
  Pieces(Real r, const OffsetOptions& options) : r_(r), options_(options) {}

  /// Adds the pieces on the right side of a closed path. `is_end` tells the ends of a polyline.
  template <typename IsEnd>
  void add(const std::vector<Vec>& path, IsEnd is_end) {
    const std::size_t n = path.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec p = path[i], q = path[(i + 1) % n];
      const Vec before = unit(p - path[(i + n - 1) % n]), after = unit(q - p);
      const Vec m = r_ * right(after);
      polygons_.push_back({p, p + m, q + m, q});
      if (is_end(i)) {
        add_end(p, before);
      } else if (cross(before, after) > 0 || dot(before, after) < -0.999999L) {
        add_corner(p, before, after);
      }
    }
  }
  void add_point(Vec p) {
    if (options_.cap == Cap::kRound) discs_.push_back(p);
    if (options_.cap != Cap::kSquare) return;
    polygons_.push_back({p + Vec{-r_, -r_}, p + Vec{r_, -r_}, p + Vec{r_, r_}, p + Vec{-r_, r_}});
  }

  [[nodiscard]] Real deepest(Vec x) const {
    Real most = -HUGE_VALL;
    for (const auto& polygon : polygons_) most = std::max(most, depth(polygon, x));
    for (const Vec centre : discs_) most = std::max(most, r_ - length(x - centre));
    for (const Sector& sector : sectors_) most = std::max(most, depth_in(sector, x));
    return most;
  }

 private:
  static Vec unit(Vec a) { return (1 / length(a)) * a; }
  static Vec right(Vec a) { return {a.y, -a.x}; }

  /// A sector of a disc, from one radius to another on its left.
  struct Sector {
    Vec centre;
    Vec first;
    Vec last;
  };
  [[nodiscard]] Real depth_in(const Sector& sector, Vec x) const {
    const Vec arm = x - sector.centre;
    return std::min(
        {r_ - length(arm), cross(sector.first, arm) / r_, cross(arm, sector.last) / r_});
  }

  void add_end(Vec v, Vec before) {
    const Vec m = r_ * right(before);
    if (options_.cap == Cap::kRound) sectors_.push_back({v, m, -1 * m});
    if (options_.cap == Cap::kSquare) add_square(v, before, -1 * before);
  }
  void add_corner(Vec v, Vec before, Vec after) {
    const Vec m1 = r_ * right(before), m2 = r_ * right(after);
    if (options_.join == Join::kRound) return sectors_.push_back({v, m1, m2});
    const Real reach = 1 / std::sqrt(std::max<Real>(0, (1 + dot(before, after)) / 2));
    if (options_.join == Join::kBevel) {
      polygons_.push_back({v, v + m1, v + m2});
    } else if (options_.join == Join::kMiter && reach <= options_.miter_limit.to_double()) {
      const Vec tip = (reach * r_) * unit(m1 + m2);
      polygons_.push_back({v, v + m1, v + tip, v + m2});
    } else {
      add_square(v, before, after);
    }
  }
  void add_square(Vec v, Vec before, Vec after) {
    const Vec m1 = r_ * right(before), m2 = r_ * right(after);
    // The tangents at m1 and at the bisector, half the turn apart, meet at r·tan(turn / 4). The
    // bisector is `before` for a turn back.
    const Real turn = std::fabs(std::atan2(cross(before, after), dot(before, after)));
    const Real f = std::tan(turn / 4) * r_;
    polygons_.push_back({v, v + m1, v + m1 + f * before, v + m2 - f * after, v + m2});
  }

  Real r_;
  OffsetOptions options_;
  std::vector<std::vector<Vec>> polygons_;
  std::vector<Vec> discs_;
  std::vector<Sector> sectors_;
};

std::vector<Vec> to_path(const std::vector<Point>& points) {
  std::vector<Vec> path;
  for (const Point& p : points) {
    if (path.empty() || length(path.back() - to_vec(p)) > 0) path.push_back(to_vec(p));
  }
  return path;
}

void add_rings(const Region& region, bool inwards, Pieces& pieces) {
  for (const std::size_t polygon : region.polygons()) {
    const Polygon rings = region.polygon(polygon);
    std::vector<Ring> all = rings.holes;
    all.push_back(rings.outer);
    for (Ring& ring : all) {
      if (inwards) std::reverse(ring.begin(), ring.end());
      pieces.add(to_path(ring), [](std::size_t) { return false; });
    }
  }
}

void add_line(const Polyline& line, Pieces& pieces) {
  std::vector<Vec> path = to_path(line);
  if (path.size() == 1) return pieces.add_point(path[0]);
  const std::size_t last = path.size() - 1;
  std::vector<Vec> back(path.rbegin(), path.rend());
  if (length(path[0] - path[last]) == 0) {
    for (std::vector<Vec>* const way : {&path, &back}) {
      way->pop_back();
      pieces.add(*way, [](std::size_t) { return false; });
    }
    return;
  }
  path.insert(path.end(), back.begin() + 1, back.end() - 1);
  pieces.add(path, [last](std::size_t i) { return i == 0 || i == last; });
}

/// The tolerance as a share of the distance.
constexpr Real kTolerance = 1e-4L;

class Comparison {
 public:
  /// A must be resolved, except for its polylines.
  Comparison(const Geometry& a, const Rational& d, OffsetOptions options)
      : a_(a), inwards_(d.sign() < 0), size_(std::fabs(d.to_double())), pieces_(size_, options) {
    options.tolerance = Rational(inwards_ ? -1 : 1, 10000) * d;
    result_ = offset(a, d, options);
    add_rings(a.region, inwards_, pieces_);
    if (inwards_) return;
    for (const Polyline& line : a.polylines) add_line(line, pieces_);
    for (const Point& point : a.points) pieces_.add_point(to_vec(point));
  }

  /// Returns whether the result is right at x; nothing if x is too close to a piece's boundary.
  [[nodiscard]] std::optional<bool> is_right(const Point& x) const {
    const Real sure = 2 * kTolerance * size_;
    const Real deepest = pieces_.deepest(to_vec(x));
    if (std::fabs(deepest) < sure) return {};
    const auto where = reference::locate(reference::to_pt(x), a_.region);
    if (where == reference::Side::kBoundary) return {};
    const bool in_set = where == reference::Side::kInside;
    const bool expected = inwards_ ? in_set && deepest < 0 : in_set || deepest > 0;
    const auto found = reference::locate(reference::to_pt(x), result_.region);
    return (found == reference::Side::kInside) == expected;
  }

 private:
  const Geometry& a_;
  bool inwards_;
  Real size_;
  Pieces pieces_;
  Geometry result_;
};

TEST(Offset, IsTheUnionOfItsPieces) {
  Random random(seed_from_environment(6));
  int points = 0;
  for (int i = 0; i < count_from_environment(kShapes); ++i) {
    const bool thin = i % 3 == 0;
    const Geometry a =
        thin ? random_thin(random, 20) : of_area(resolve(of_area(random_region(random))).region);
    const Rational d(random.between(1, 24) * (i % 2 == 0 || thin ? 1 : -1), 8);
    for (const Join join : kJoins) {
      for (const Cap cap : kCaps) {
        if (!thin && cap != Cap::kButt) continue;
        OffsetOptions options = with(join, cap);
        options.miter_limit = Rational(random.between(10, 40), 10);
        const Comparison comparison(a, d, options);
        for (int k = 0; k < 25; ++k) {
          const Point x{Rational(random.between(-6000, 30000), 1000),
                        Rational(random.between(-6000, 30000), 1000)};
          const auto right = comparison.is_right(x);
          points += right ? 1 : 0;
          EXPECT_TRUE(right.value_or(true))
              << to_string(join) << ' ' << to_string(cap) << ' ' << message(a, d) << ' ' << x.x
              << ' ' << x.y << " limit " << options.miter_limit;
        }
      }
    }
  }
  EXPECT_GT(points, 100 * count_from_environment(kShapes));
}

}  // namespace
}  // namespace minksum

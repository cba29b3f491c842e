// Makes polygons for discs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "minksum/error.hpp"
#include "operations/offset/decimal_grid.hpp"
#include "operations/offset/make_disc.hpp"

namespace minksum {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kMaxEdgesOfQuarter = 1 << 18;
constexpr std::uint64_t kWork = 32;  ///< units of work of a vertex, in each of three loops
constexpr double kLeast = 0x1p-200;  ///< doubles hold products of two lengths from this one on

/// Returns the angle whose cosine is 1 − gap/whole. Unlike acos, it loses nothing for small angles.
double angle_of(double gap, double whole) { return 2 * std::asin(std::sqrt(gap / (2 * whole))); }

/// The vertices of a quarter, from the one after the x-axis, or on it, to the one before the
/// y-axis. Angles are chosen in doubles, and the result is verified.
class Quarter {
 public:
  Quarter(const Rational& radius, const Rational& tolerance, RoundingSide side,
          Cancellation& cancellation)
      : cancellation_(cancellation),
        radius_(radius),
        inner_(side == RoundingSide::kOutside ? radius : radius - tolerance),
        outer_(side == RoundingSide::kInside ? radius : radius + tolerance),
        grid_(DecimalGrid::below(tolerance / Rational(64))) {
    const Rational diagonal = radius * radius + radius * radius;
    if (side != RoundingSide::kInside && diagonal <= outer_ * outer_) {
      vertices_ = {{radius, radius}};
    } else {
      place(side == RoundingSide::kInside);
    }
    verify();
  }
  [[nodiscard]] const std::vector<Point>& vertices() const { return vertices_; }

 private:
  /// Computes in steps of the grid. Rounding moves vertices, and so edges, by less than one step.
  /// All vertices except those beside the axes are placed one step within the outer circle, and all
  /// edges keep one step from the inner one. That leaves at least 62 of 64 steps of the tolerance.
  void place(bool inside) {
    const auto steps = [this](const Rational& length) {
      return (length / grid_.step()).to_double();
    };
    const double circle = steps(outer_) - 1;
    // These are angles of half an edge, seen from the centre: `half` of an edge that touches the
    // inner circle, `first` of one that an axis cuts at right angles, at exactly the radius.
    const double half = angle_of(steps(outer_ - inner_) - 2, circle);
    const double first = inside ? 0 : angle_of(steps(outer_ - radius_) - 1, circle);
    const double edges = std::ceil((kRightAngle - 2 * first) / (2 * half));
    if (!(edges < kMaxEdgesOfQuarter)) {
      throw Error(ErrorCode::kLimitExceeded,
                  "a disc of this tolerance would have more than 2^20 vertices");
    }
    const auto count = static_cast<std::size_t>(std::max(edges, 1.0));
    const double angle = (kRightAngle - 2 * first) / static_cast<double>(count);
    vertices_.resize(count + 1);
    vertices_[0] = {radius_, grid_.at(inside ? 0 : std::floor(circle * std::sin(first)))};
    for (std::size_t i = 1; 2 * i <= count; ++i) {
      cancellation_.check(kWork);
      const double at = first + static_cast<double>(i) * angle;
      vertices_[i] = {grid_.at(circle * std::cos(at)), grid_.at(circle * std::sin(at))};
    }
    if (count % 2 == 0) vertices_[count / 2].y = vertices_[count / 2].x;
    for (std::size_t i = 0; 2 * i < count; ++i) {
      vertices_[count - i] = {vertices_[i].y, vertices_[i].x};
    }
    if (inside) vertices_.pop_back();  // the next quarter begins with it
  }

  /// Verifies the quarter. It goes left around the origin within its quadrant, so D is star-shaped.
  /// All vertices are within the outer circle, and all edges' lines outside of the inner one.
  void verify() const {
    const Point next{-vertices_[0].y, vertices_[0].x};
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      cancellation_.check(kWork);
      const Point& a = vertices_[i];
      const Point& b = i + 1 < vertices_.size() ? vertices_[i + 1] : next;
      if (!is_clearly_right(a, b) && !is_right(a, b)) {
        throw Error(ErrorCode::kInternal, "a disc is not within its tolerance", {}, "offset");
      }
    }
  }
  /// Whether doubles show that a vertex and the edge to the next one are right. They do so as
  /// long as a step, which vertices and edges keep from the circles, is no smaller than roundings.
  [[nodiscard]] bool is_clearly_right(const Point& a, const Point& b) const {
    constexpr double kRelative = 0x1p-50;  // a relative error of a few operations
    const auto [ax, ay, bx, by, inner, outer] =
        std::array{a.x.to_double(), a.y.to_double(),    b.x.to_double(),
                   b.y.to_double(), inner_.to_double(), outer_.to_double()};
    const double x = std::abs(bx - ax) + kRelative * (std::abs(ax) + std::abs(bx));
    const double y = std::abs(by - ay) + kRelative * (std::abs(ay) + std::abs(by));
    const double cross = ax * by - ay * bx - kRelative * (std::abs(ax * by) + std::abs(ay * bx));
    return ax >= 0 && ay >= 0 && inner >= kLeast && outer <= 1 / kLeast && cross > 0 &&
           (ax * ax + ay * ay) * (1 + 4 * kRelative) <= outer * outer &&
           cross >= inner * std::sqrt(x * x + y * y) * (1 + 4 * kRelative);
  }
  [[nodiscard]] bool is_right(const Point& a, const Point& b) const {
    const Rational x = b.x - a.x;
    const Rational y = b.y - a.y;
    const Rational cross = a.x * b.y - a.y * b.x;
    return a.x.sign() >= 0 && a.y.sign() >= 0 && cross.sign() > 0 &&
           a.x * a.x + a.y * a.y <= outer_ * outer_ &&
           cross * cross >= inner_ * inner_ * (x * x + y * y);
  }

  Cancellation& cancellation_;
  Rational radius_;
  Rational inner_;
  Rational outer_;
  DecimalGrid grid_;
  std::vector<Point> vertices_;
};

}  // namespace

Region disc(const Rational& radius, const Rational& tolerance, RoundingSide side) {
  Cancellation cancellation;
  return make_disc(radius, tolerance, side, cancellation);
}

Region make_disc(const Rational& radius, const Rational& tolerance, RoundingSide side,
                 Cancellation& cancellation) {
  require_enumerator(side, RoundingSide::kInside, "side");
  if (radius.sign() <= 0) refuse_input("a disc's radius must be positive");
  if (tolerance.sign() <= 0) refuse_input("a tolerance must be positive");
  const Quarter quarter(radius, std::min(tolerance, radius / Rational(2)), side, cancellation);
  Region result;
  result.begin_polygon();
  result.begin_ring();
  // The canonical form starts at the lowest of the leftmost vertices.
  for (const int turns : {2, 3, 0, 1}) {
    for (const auto& [x, y] : quarter.vertices()) {
      cancellation.check(kWork);
      const Rational& along = turns % 2 == 0 ? x : y;
      const Rational& across = turns % 2 == 0 ? y : x;
      result.add_vertex(turns == 1 || turns == 2 ? -along : along, turns >= 2 ? -across : across);
    }
  }
  return result;
}

}  // namespace minksum

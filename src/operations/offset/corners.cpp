#include "operations/offset/corners.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "minksum/error.hpp"

namespace minksum {
namespace {

/// Tells whether a ≥ b·√c, for c ≥ 0.
bool at_least(const Rational& a, const Rational& b, const Rational& c) {
  if (a.sign() >= 0 && b.sign() <= 0) return true;
  if (a.sign() <= 0 && b.sign() >= 0) return a.sign() == 0 && (b.sign() == 0 || c.sign() == 0);
  const std::strong_ordering order = a * a <=> b * b * c;
  return a.sign() > 0 ? order >= 0 : order <= 0;
}

/// The angle θ by which the path turns left from one edge to the next, from 0 to 180 degrees.
struct Bend {
  Rational sine;  // these two are multiplied by `length`
  Rational cosine;
  Rational squared;  // length²

  Bend(const OffsetEdge& first, const OffsetEdge& second)
      : sine(cross(first.along, second.along)),
        cosine(dot(first.along, second.along)),
        squared(first.squared * second.squared) {}

  /// Returns tan θ/2 = sin θ/(1 + cos θ). `quarter` returns tan θ/4.
  [[nodiscard]] double half() const {
    const double s = sine.to_double(), c = cosine.to_double(), l = std::sqrt(squared.to_double());
    return c >= 0 ? s / (l + c) : (l - c) / s;
  }
  [[nodiscard]] double quarter() const {
    const double s = sine.to_double(), c = cosine.to_double(), l = std::sqrt(squared.to_double());
    if (c < 0) return 1 / (s / (l - c) + std::hypot(1, s / (l - c)));
    return s / (l + c) / (1 + std::hypot(1, s / (l + c)));
  }
  /// Compare tan θ/2 with p/q, for q > 0, by the sign of sin θ·q − (1 + cos θ)·p.
  [[nodiscard]] bool half_at_least(const Rational& p, const Rational& q) const {
    return at_least(sine * q - cosine * p, p, squared);
  }
  [[nodiscard]] bool half_at_most(const Rational& p, const Rational& q) const {
    return at_least(cosine * p - sine * q, -p, squared);
  }
};

[[noreturn]] void fail(const char* what) { throw Error(ErrorCode::kInternal, what, {}, "offset"); }

/// Tells whether a direction comes second in the order of angles: those below the x-axis come
/// first.
bool is_above(const Point& a) { return a.y.sign() > 0 || (a.y.sign() == 0 && a.x.sign() > 0); }

bool has_lower_angle(const Point& a, const Point& b) {
  if (is_above(a) != is_above(b)) return is_above(b);
  return cross(a, b).sign() > 0;
}

/// Tells whether no vector is a right turn from the one before it.
bool turns_left(const std::vector<Point>& vectors) {
  for (std::size_t i = 0; i + 1 < vectors.size(); ++i) {
    if (cross(vectors[i], vectors[i + 1]).sign() < 0) return false;
  }
  return true;
}

/// Doubles hold the squares of vectors whose lengths lie between these two.
constexpr double kLong = 0x1p200;
constexpr double kShort = 0x1p-200;

}  // namespace

Corners::Corners(const Rational& distance, const Rational& tolerance, const OffsetOptions& options)
    : distance_(distance),
      join_(options.join),
      cap_(options.cap),
      least_cosine_(Rational(2) / (options.miter_limit * options.miter_limit) - Rational(1)),
      grid_(DecimalGrid::below(
          tolerance /
          (Rational(64) * (join_ == Join::kMiter ? options.miter_limit : Rational(1))))),
      epsilon_(grid_.step() / distance),
      squared_step_(grid_.step() * grid_.step()),
      distance_in_steps_((distance / grid_.step()).to_double()) {
  const Rational limit = join_ == Join::kMiter ? options.miter_limit : Rational(1);
  if (tolerance * Rational(10000000000) < distance * limit * limit) {
    throw Error(ErrorCode::kLimitExceeded,
                "the tolerance is below 10^-10 of the distance times the miter limit squared");
  }
  if (join_ != Join::kRound && cap_ != Cap::kRound) return;
  // Its vertices are on the circle, as the ends of `outwards` are. So an edge from such an end to
  // the next vertex is no farther from the circle than other edges are.
  const Region circle = disc(distance, tolerance * Rational(7, 8), RoundingSide::kInside);
  for (const std::size_t v : circle.vertices_of(0)) disc_.push_back(circle.point(v));
}

OffsetEdge Corners::edge(Point along) const {
  double x = along.x.to_double(), y = along.y.to_double();
  const double longest = std::max(std::abs(x), std::abs(y));
  if (!(longest > kShort && longest < kLong)) {
    const Rational size =
        std::max(along.x.sign() < 0 ? -along.x : along.x, along.y.sign() < 0 ? -along.y : along.y);
    along = {along.x / size, along.y / size};
    x = along.x.to_double();
    y = along.y.to_double();
  }
  OffsetEdge edge{std::move(along), {}, {}};
  edge.squared = dot(edge.along, edge.along);
  const auto signed_distance = [this](int sign) { return sign < 0 ? -distance_ : distance_; };
  if (edge.along.y.sign() == 0) {
    edge.outwards = {0, signed_distance(-edge.along.x.sign())};
    return edge;
  }
  if (edge.along.x.sign() == 0) {
    edge.outwards = {signed_distance(edge.along.y.sign()), 0};
    return edge;
  }
  const double scale = distance_in_steps_ / std::hypot(x, y);
  Point& m = edge.outwards = {grid_.at(y * scale), grid_.at(-x * scale)};
  // |m − d·n|² = m² + d² − 2d·(m·n) ≤ (2h)², where n is `right` divided by its length.
  const Point right{edge.along.y, -edge.along.x};
  const Rational rest = dot(m, m) + distance_ * distance_ - Rational(4) * squared_step_;
  const Rational along_normal = (distance_ + distance_) * dot(m, right);
  // m is on the edge's right side, so the strip up to it goes counter-clockwise.
  if (dot(m, right).sign() <= 0 || !at_least(along_normal, rest, edge.squared)) {
    fail("a normal is not within the tolerance");
  }
  return edge;
}

/// Returns `outwards` plus `tangent` times its length along the edge, on the grid. On the lines of
/// those edges among `on` that are axis-parallel, it lies exactly.
Point Corners::beyond(const Point& outwards, double tangent,
                      std::initializer_list<const Point*> on) const {
  const Rational t(tangent);
  const Point exact{outwards.x - t * outwards.y, outwards.y + t * outwards.x};
  Point result{grid_.at((exact.x / grid_.step()).to_double()),
               grid_.at((exact.y / grid_.step()).to_double())};
  const Point error = minus(result, exact);
  if (dot(error, error) > squared_step_) fail("a corner is not within the tolerance");
  // On such a line the true corner's coordinate is known exactly, so errors do not grow.
  for (const Point* const line : on) {
    if (line->x.sign() == 0) result.y = line->y;
    if (line->y.sign() == 0) result.x = line->x;
  }
  return result;
}

/// Returns the vector to where both moved edges meet: by d·tan θ/2 along the first.
std::vector<Point> Corners::miter(const OffsetEdge& first, const OffsetEdge& second) const {
  const Bend turn(first, second);
  const double tangent = turn.half();
  const Rational low = Rational(tangent) - epsilon_;
  const Rational high = Rational(tangent) + epsilon_;
  if ((low.sign() > 0 && !turn.half_at_least(low, 1)) || !turn.half_at_most(high, 1)) {
    fail("a miter is not within the tolerance");
  }
  return {beyond(first.outwards, tangent, {&first.outwards, &second.outwards})};
}

/// Returns vectors by d·tan θ/4 along the first edge, and by as much back along the second. There
/// the cut at right angles to the bisector meets both.
std::vector<Point> Corners::square(const OffsetEdge& first, const OffsetEdge& second) const {
  const Bend turn(first, second);
  const double tangent = turn.quarter();
  const Rational low = Rational(tangent) - epsilon_;
  const Rational high = Rational(tangent) + epsilon_;
  // tan θ/2 = 2q/(1 − q²) grows with q = tan θ/4, which is at most 1.
  const auto half = [](const Rational& q) { return std::pair{q + q, Rational(1) - q * q}; };
  const auto [p, q] = half(low);
  const auto [r, s] = half(high);
  if ((low.sign() > 0 && !turn.half_at_least(p, q)) || (s.sign() > 0 && !turn.half_at_most(r, s))) {
    fail("a square join is not within the tolerance");
  }
  return {beyond(first.outwards, tangent, {&first.outwards}),
          beyond(second.outwards, -tangent, {&second.outwards})};
}

/// Returns the disc's vertices strictly between two directions.
std::vector<Point> Corners::arc(const Point& from, const Point& to) const {
  std::vector<Point> result;
  const auto begin = std::upper_bound(disc_.begin(), disc_.end(), from, has_lower_angle);
  auto i = static_cast<std::size_t>(begin - disc_.begin());
  for (std::size_t count = 0; count < disc_.size(); ++count, ++i) {
    const Point& vertex = disc_[i % disc_.size()];
    if (cross(from, vertex).sign() <= 0 || cross(vertex, to).sign() <= 0) break;
    result.push_back(vertex);
  }
  return result;
}

CornerOutline Corners::between(const OffsetEdge& first, const OffsetEdge& second, Join join) const {
  const Point& begin = first.outwards;
  const Point& end = second.outwards;
  const int side = cross(first.along, second.along).sign();
  const bool forwards = dot(first.along, second.along).sign() > 0;
  // By rounding, normals of nearly parallel edges may turn the other way. The strips overlap then.
  std::vector<Point> bevel =
      cross(begin, end).sign() >= 0 ? std::vector{begin, end} : std::vector{begin, Point{}, end};
  if (side < 0 || (side == 0 && forwards)) {
    if (side < 0) bevel = {begin, {}, end};
    return {bevel, bevel};
  }
  CornerOutline outline;
  if (join == Join::kMiter &&
      at_least(dot(first.along, second.along), least_cosine_, first.squared * second.squared)) {
    outline.direct = miter(first, second);
  } else if (join == Join::kMiter || join == Join::kSquare) {
    outline.direct = square(first, second);
  } else if (join == Join::kRound) {
    outline.full = arc(begin, end);
  }
  if (!outline.direct.empty()) outline.full = outline.direct;
  outline.full.insert(outline.full.begin(), begin);
  outline.full.push_back(end);
  if (!turns_left(outline.full)) outline = {bevel, bevel};
  if (outline.direct.empty()) outline.direct = outline.full;
  return outline;
}

CornerOutline Corners::at_end(const OffsetEdge& first, const OffsetEdge& second) const {
  switch (cap_) {
    case Cap::kRound:
      return between(first, second, Join::kRound);
    case Cap::kSquare:
      return between(first, second, Join::kSquare);
    case Cap::kButt:
      break;
  }
  return between(first, second, Join::kBevel);
}

}  // namespace minksum

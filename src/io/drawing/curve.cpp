#include "io/drawing/curve.hpp"

#include <algorithm>
#include <cmath>

namespace minksum::io {
namespace {

Bezier<Interval> seen_from(const Point& origin, std::span<const Point> controls, bool backwards) {
  Bezier<Interval> result;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const Span at = span_between(origin, controls[backwards ? controls.size() - 1 - i : i]);
    result.push_back({at.x, at.y, Interval(1)});
  }
  return result;
}

/// Adds the parts of an arc that begins at `at`. A part is at most about a right angle: halves of
/// an arc have half its angle, and tan x/2 = tan x / (1 + √(1 + tan² x)).
void add_arc(const Span& at, const Span& half, const Span& turned, const Interval& bulge,
             std::vector<Bezier<Interval>>& parts) {
  constexpr double kRightAngle = 0.42;  // a little more than tan 22.5°
  const Interval square = bulge * bulge;
  if (std::abs(bulge.middle()) > kRightAngle) {
    const Interval less = bulge / (Interval(1) + square_root(Interval(1) + square));
    const Span to_top = half - bulge * turned;
    const Span top_turned = turned + bulge * half;
    const Span from_top = half + bulge * turned;
    const Span rest_turned = turned - bulge * half;
    const Interval by_half(0.5);
    add_arc(at, by_half * to_top, by_half * top_turned, less, parts);
    return add_arc(at + to_top, by_half * from_top, by_half * rest_turned, less, parts);
  }
  const Interval one(1);
  const Interval cosine = (one - square) / (one + square);
  const Interval sine = (bulge + bulge) / (one + square);
  const Span middle = cosine * (at + half) - sine * turned;
  const Span end = at + half + half;
  Bezier<Interval> part;
  part.push_back({at.x, at.y, one});
  part.push_back({middle.x, middle.y, cosine});
  part.push_back({end.x, end.y, one});
  parts.push_back(part);
}

/// Puts the ends where they are known exactly.
Curve with_ends(const Point& from, const Point& to, std::vector<Bezier<Interval>> parts,
                Bezier<Interval> ending) {
  const auto put = [](Control<Interval>& control, const Span& at) {
    control = {at.x * control.w, at.y * control.w, control.w};
  };
  const Span span = span_between(from, to);
  put(parts.front()[0], {});
  put(parts.back()[parts.back().size() - 1], span);
  put(ending[0], {});
  if (parts.size() == 1) put(ending[ending.size() - 1], {-span.x, -span.y});
  return {from, to, std::move(parts), ending};
}

/// Returns the parts of a spline, relative to the point in which `forwards` begins.
class SplineParts {
 public:
  SplineParts(std::size_t degree, std::span<const Point> controls, std::span<const Rational> knots)
      : degree_(degree) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
      knots_.push_back(Interval::of(knots[i] - knots[degree]));
      first_.push_back(i > 0 && knots[i] == knots[i - 1] ? first_.back() : i);
    }
    for (std::size_t i = degree; i < controls.size(); ++i) {
      const bool is_point = are_one_point(controls.subspan(i - degree, degree + 1));
      if (knots[i] < knots[i + 1] && !is_point) spans_.push_back(i);
    }
  }
  [[nodiscard]] std::vector<Bezier<Interval>> of(
      const std::vector<Control<Interval>>& controls) const {
    std::vector<Bezier<Interval>> parts;
    for (const std::size_t span : spans_) {
      Bezier<Interval> part;
      for (std::size_t k = 0; k <= degree_; ++k) part.push_back(blossom(controls, span, k));
      parts.push_back(part);
    }
    return parts;
  }

 private:
  /// Returns the blossom at the span's end k times, and otherwise at its begin: Bezier's control
  /// point k.
  [[nodiscard]] Control<Interval> blossom(const std::vector<Control<Interval>>& controls,
                                          std::size_t span, std::size_t k) const {
    const std::size_t p = degree_;
    std::vector<Control<Interval>> d(controls.begin() + static_cast<std::ptrdiff_t>(span - p),
                                     controls.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t r = 1; r <= p; ++r) {
      const std::size_t at = r <= k ? span + 1 : span;
      for (std::size_t j = p; j >= r; --j) {
        const std::size_t low = j + span - p;
        const std::size_t high = j + 1 + span - r;
        // Equal knots give exactly 0 or 1, which keeps ends of splines exact.
        if (first_[low] == first_[at]) {
          d[j] = d[j - 1];
        } else if (first_[high] != first_[at]) {
          const Interval whole = knots_[high] - knots_[low];
          const Interval f = (knots_[at] - knots_[low]) / whole;
          const Interval g = (knots_[high] - knots_[at]) / whole;
          d[j] = {g * d[j - 1].x + f * d[j].x, g * d[j - 1].y + f * d[j].y,
                  g * d[j - 1].w + f * d[j].w};
        }
      }
    }
    return d[p];
  }

  std::size_t degree_;
  std::vector<Interval> knots_;
  std::vector<std::size_t> first_;  ///< for each knot, the index of the first one that is equal
  std::vector<std::size_t> spans_;  ///< indices of knots at which a part begins
};

}  // namespace

bool are_one_point(std::span<const Point> controls) {
  return std::all_of(controls.begin(), controls.end(),
                     [&](const Point& control) { return control == controls.front(); });
}

Span span_between(const Point& a, const Point& b) {
  return {Interval::of(b.x - a.x), Interval::of(b.y - a.y)};
}

Curve bezier_curve(std::span<const Point> controls) {
  return {controls.front(),
          controls.back(),
          {seen_from(controls.front(), controls, false)},
          seen_from(controls.back(), controls, true)};
}

Curve elliptical_arc(const Point& from, const Point& to, const Span& half, const Span& turned,
                     const Interval& bulge) {
  std::vector<Bezier<Interval>> parts;
  add_arc({}, half, turned, bulge, parts);
  std::vector<Bezier<Interval>> backwards;
  add_arc({}, {-half.x, -half.y}, {-turned.x, -turned.y}, -bulge, backwards);
  return with_ends(from, to, std::move(parts), backwards.front());
}

Curve circular_arc(const Point& from, const Point& to, const Interval& bulge) {
  const Span half = Interval(0.5) * span_between(from, to);
  return elliptical_arc(from, to, half, {-half.y, half.x}, bulge);
}

std::vector<Bezier<Interval>> spline_parts(const Point& origin, std::size_t degree,
                                           std::span<const Point> controls,
                                           std::span<const Rational> knots,
                                           std::span<const Rational> weights) {
  std::vector<Control<Interval>> seen;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const Span at = span_between(origin, controls[i]);
    const Interval weight = weights[i] == Rational(1) ? Interval(1) : Interval::of(weights[i]);
    seen.push_back({weight * at.x, weight * at.y, weight});
  }
  return SplineParts(degree, controls, knots).of(seen);
}

Curve spline_curve(const Point& from, const Point& to, std::size_t degree,
                   std::span<const Point> controls, std::span<const Rational> knots,
                   std::span<const Rational> weights) {
  return with_ends(from, to, spline_parts(from, degree, controls, knots, weights),
                   spline_parts(to, degree, controls, knots, weights).back().reversed());
}

}  // namespace minksum::io

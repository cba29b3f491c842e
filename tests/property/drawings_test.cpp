// Reads random arcs, ellipses and splines of drawings, and decides exactly that points of the true
// curves lie on the side that is asked for, within the tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/locate.hpp"
#include "minksum/resolve.hpp"
#include "support/generators.hpp"
#include "support/random.hpp"

namespace minksum {
namespace {

using test::Random;

/// A closed shape: a curve, and straight pieces between its ends.
struct Shape {
  std::string text;             ///< the drawing
  std::vector<Point> on_curve;  ///< exact points of the curve, in order
  bool convex = true;           ///< and nowhere thinner than a tolerance
  double sag = 0;               ///< bounds how far the curve is from the polyline of these points
};

Rational square(const Rational& a) { return a * a; }
std::string text_of(const Rational& value) { return value.to_decimal(6); }
std::string text_of(const Point& p) { return text_of(p.x) + "," + text_of(p.y); }

/// Returns the exact squared distance of x from the segment ab.
Rational squared_distance(const Point& x, const Point& a, const Point& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  Rational t(0);
  if (const Rational length = dx * dx + dy * dy; length.sign() > 0) {
    t = ((x.x - a.x) * dx + (x.y - a.y) * dy) / length;
    if (t.sign() < 0) t = 0;
    if (t > Rational(1)) t = 1;
  }
  return square(x.x - a.x - t * dx) + square(x.y - a.y - t * dy);
}

/// A point in doubles.
struct Near {
  double x, y;
};
Near near(const Point& p) { return {p.x.to_double(), p.y.to_double()}; }

/// Bounds the roundings of this test's own doubles, with coordinates below 1000.
constexpr double kRounding = 1e-9;

double distance(const Near& v, const Near& a, const Near& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double x = v.x - a.x, y = v.y - a.y;
  const double length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp((x * dx + y * dy) / length, 0.0, 1.0) : 0;
  return std::hypot(x - t * dx, y - t * dy);
}

/// A region's edges, exactly and in doubles.
class Boundary {
 public:
  explicit Boundary(const Region& region) {
    for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
      const IndexRange range = region.vertices_of(ring);
      std::size_t before = range.front() + range.size() - 1;
      for (const std::size_t v : range) {
        const Point a = region.point(before), b = region.point(v);
        edges_.push_back({a, b, near(a), near(b)});
        before = v;
      }
    }
  }
  /// Decides exactly. Doubles leave out edges that are certainly farther away.
  [[nodiscard]] bool is_within(const Rational& tolerance, const Point& x) const {
    const double farther = tolerance.to_double() + kRounding;
    const Near at = near(x);
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
      return distance(at, edge.near_a, edge.near_b) <= farther &&
             squared_distance(x, edge.a, edge.b) <= square(tolerance);
    });
  }

 private:
  struct Edge {
    Point a, b;
    Near near_a, near_b;
  };
  std::vector<Edge> edges_;
};

/// Tells whether a vertex is within `most` of the closed polyline of these points.
bool is_near_curve(const Near& v, const std::vector<Near>& curve, double most) {
  double best = distance(v, curve.back(), curve.front());
  for (std::size_t i = 1; i < curve.size(); ++i) {
    best = std::min(best, distance(v, curve[i - 1], curve[i]));
  }
  return best <= most;
}

/// Checks what is read of a shape, for all sides. Every `step`-th point is located.
void check(const Shape& shape, const Rational& tolerance, std::size_t step) {
  std::vector<Near> curve;
  for (const Point& p : shape.on_curve) curve.push_back(near(p));
  for (const RoundingSide side :
       {RoundingSide::kNearest, RoundingSide::kOutside, RoundingSide::kInside}) {
    io::ReadOptions options;
    options.drawing.tolerance = tolerance;
    options.drawing.side = side;
    SCOPED_TRACE(std::string(to_string(side)) + ", tolerance " + tolerance.to_string() + '\n' +
                 shape.text);
    Region region;
    ASSERT_NO_THROW(region = io::read(shape.text, options));
    // Areas may lose, or fill, what is thinner than the tolerance.
    if (side == RoundingSide::kInside && !shape.convex && region.empty()) continue;
    ASSERT_FALSE(region.empty());
    const PointLocator locator(region);
    const Boundary boundary(region);
    for (std::size_t i = 0; i < shape.on_curve.size(); i += step) {
      const Point& x = shape.on_curve[i];
      const Location location = locator.locate(x);
      const bool right =
          side == RoundingSide::kNearest ||
          location != (side == RoundingSide::kOutside ? Location::kOutside : Location::kInside);
      ASSERT_TRUE(right) << "point " << x.x << ' ' << x.y;
      if (side != RoundingSide::kNearest && !shape.convex) continue;
      ASSERT_TRUE(boundary.is_within(tolerance, x)) << "point " << x.x << ' ' << x.y;
    }
    // Up to the sag, and roundings of doubles.
    const double most = tolerance.to_double() + shape.sag + kRounding;
    for (std::size_t v = 0; v < region.vertex_count(); ++v) {
      ASSERT_TRUE(is_near_curve(near(region.point(v)), curve, most))
          << "vertex " << region.x(v) << ' ' << region.y(v);
    }
  }
}

class Curves {
 public:
  explicit Curves(Random& random) : random_(random) {}

  Rational number(double low, double high) {
    const auto in_thousandths = [](double value) { return static_cast<int>(value * 1000); };
    return Rational(Decimal{random_.between(in_thousandths(low), in_thousandths(high)), -3});
  }
  Rational tolerance() {
    static const std::array kTolerances = {Rational(1, 2), Rational(1, 10), Rational(1, 100),
                                           Rational(1, 1000), Rational(7, 100000)};
    return kTolerances[static_cast<std::size_t>(random_.below(5))];
  }

  /// A polyline of DXF with one arc, whose bulge is rational. Its points are on a circle, exactly.
  Shape bulge() {
    const Point a{number(-50, 50), number(-50, 50)}, b{a.x + number(1, 40), a.y + number(-40, 40)};
    Rational bulge = number(-3, 3);
    if (bulge.sign() == 0) bulge = 1;
    const Rational one(1), whole = one + bulge * bulge;
    const Rational cosine = (one - bulge * bulge) / whole, sine = (bulge + bulge) / whole;
    const Point half{(b.x - a.x) / Rational(2), (b.y - a.y) / Rational(2)};
    const Point middle{cosine * (a.x + half.x) + sine * half.y,
                       cosine * (a.y + half.y) - sine * half.x};
    const Rational up = (one - bulge * bulge) / (bulge + bulge);
    const Point centre{a.x + half.x - up * half.y, a.y + half.y + up * half.x};
    const Rational radius = square(a.x - centre.x) + square(a.y - centre.y);
    Shape shape;
    constexpr int kPoints = 200;
    for (int i = 0; i <= kPoints; ++i) {
      const Rational t(i, kPoints), s = one - t;
      const Rational w = s * s + Rational(2) * s * t * cosine + t * t;
      const auto at = [&](const Rational& p, const Rational& q, const Rational& r) {
        return (s * s * p + Rational(2) * s * t * q + t * t * r) / w;
      };
      shape.on_curve.push_back({at(a.x, middle.x, b.x), at(a.y, middle.y, b.y)});
      const Point& p = shape.on_curve.back();
      EXPECT_EQ(square(p.x - centre.x) + square(p.y - centre.y), radius);
    }
    set_sag(shape, std::sqrt(radius.to_double()), 1);
    shape.text = dxf("LWPOLYLINE\n90\n2\n70\n1\n10\n" + text_of(a.x) + "\n20\n" + text_of(a.y) +
                     "\n42\n" + text_of(bulge) + "\n10\n" + text_of(b.x) + "\n20\n" + text_of(b.y));
    return shape;
  }

  /// An arc of a path in SVG. Its ends are decimals on the ellipse, so its centre is exact.
  Shape arc() {
    static const std::array<Point, 7> kDirections = {Point{1, 0},
                                                     Point{Rational(4, 5), Rational(3, 5)},
                                                     Point{Rational(3, 5), Rational(4, 5)},
                                                     Point{Rational(24, 25), Rational(7, 25)},
                                                     Point{Rational(7, 25), Rational(24, 25)},
                                                     Point{Rational(117, 125), Rational(44, 125)},
                                                     Point{Rational(44, 125), Rational(117, 125)}};
    const Point centre{number(-50, 50), number(-50, 50)};
    const Rational rx = number(1, 40), ry = number(1, 40);
    const auto direction = [&] {
      Point d = kDirections[static_cast<std::size_t>(random_.below(7))];
      if (random_.one_in(2)) d.x = -d.x;
      if (random_.one_in(2)) d.y = -d.y;
      return d;
    };
    const Point from = direction();
    Point to = direction();
    while (to == from || (to.x == -from.x && to.y == -from.y)) to = direction();
    const auto angle = [](const Point& d) { return std::atan2(d.y.to_double(), d.x.to_double()); };
    const double begin = angle(from);
    double sweep = angle(to) - begin;
    if (sweep < 0) sweep += 2 * 3.14159265358979;
    Shape shape;
    constexpr int kPoints = 200;
    shape.on_curve.push_back({centre.x + rx * from.x, -(centre.y + ry * from.y)});
    for (int i = 1; i < kPoints; ++i) {
      // The tangent of half the angle makes an exact point near it. A short one keeps all numbers
      // short.
      const double half = (begin + sweep * i / kPoints) / 2;
      const bool flipped = std::abs(std::cos(half)) < 0.5;
      const double tangent = flipped ? std::cos(half) / std::sin(half) : std::tan(half);
      const Rational k(std::llround(std::ldexp(tangent, 20)), 1 << 20);
      const Rational whole = Rational(1) + k * k;
      Rational x = (Rational(1) - k * k) / whole;
      const Rational y = (k + k) / whole;
      if (flipped) x = -x;
      shape.on_curve.push_back({centre.x + rx * x, -(centre.y + ry * y)});
    }
    shape.on_curve.push_back({centre.x + rx * to.x, -(centre.y + ry * to.y)});
    set_sag(shape, std::max(rx, ry).to_double(), (std::max(rx, ry) / std::min(rx, ry)).to_double());
    const auto at = [&](const Point& d) {
      return (centre.x + rx * d.x).to_decimal(9) + " " + (centre.y + ry * d.y).to_decimal(9);
    };
    const bool large = sweep > 3.14159265;
    shape.text = "<svg><path d=\"M" + at(from) + "A" + text_of(rx) + " " + text_of(ry) + " 0 " +
                 (large ? "1" : "0") + " 1 " + at(to) + "z\"/></svg>";
    return shape;
  }

  /// An ellipse of DXF, turned in any way.
  Shape ellipse() {
    const Point centre{number(-50, 50), number(-50, 50)}, major{number(-30, 30), number(1, 30)};
    const Rational ratio = number(0.05, 1);
    Shape shape;
    constexpr int kPoints = 300;
    const auto add = [&](const Rational& x, const Rational& y) {
      shape.on_curve.push_back({centre.x + x * major.x - y * ratio * major.y,
                                centre.y + x * major.y + y * ratio * major.x});
    };
    for (const int side : {1, -1}) {
      for (int i = -kPoints / 4; i < kPoints / 4; ++i) {
        const Rational k(4 * i, kPoints), whole = Rational(1) + k * k;
        const Rational sign(side);
        add(sign * (Rational(1) - k * k) / whole, sign * (k + k) / whole);
      }
    }
    shape.on_curve.push_back(shape.on_curve.front());
    const double size = std::hypot(major.x.to_double(), major.y.to_double());
    set_sag(shape, size, 1 / ratio.to_double());
    shape.text = dxf("ELLIPSE\n10\n" + text_of(centre.x) + "\n20\n" + text_of(centre.y) + "\n11\n" +
                     text_of(major.x) + "\n21\n" + text_of(major.y) + "\n40\n" + text_of(ratio) +
                     "\n41\n0\n42\n6.283185307179586");
    return shape;
  }

  /// A quadratic of SVG that turns back sharply. It does not cross itself, nor the straight way
  /// back.
  Shape hairpin() {
    const Point a{number(-50, 50), number(-50, 50)};
    const Point out{number(-90, 90), number(1, 90)};
    const Rational back = number(0.05, 4);
    const Rational aside = number(1, 10) * Rational(Decimal{1, -random_.between(1, 4)});
    const Point b{a.x + out.x, a.y + out.y};
    const Point c{b.x - back * out.x - aside * out.y, b.y - back * out.y + aside * out.x};
    // The text has six digits.
    const auto kept = [](const Point& p) {
      return Point{*Rational::parse(text_of(p.x)), *Rational::parse(text_of(p.y))};
    };
    const std::array<Point, 3> controls = {kept(a), kept(b), kept(c)};
    Shape shape;
    shape.convex = false;  // it may be thinner than a tolerance
    sample(shape, [&](const Rational& t) {
      const Rational s = Rational(1) - t;
      const auto mixed = [&](const Rational& p, const Rational& q, const Rational& r) {
        return s * s * p + Rational(2) * s * t * q + t * t * r;
      };
      const auto& [p, q, r] = controls;
      return Point{mixed(p.x, q.x, r.x), mixed(p.y, q.y, r.y)};
    });
    const auto flipped = [](const Point& p) { return text_of(Point{p.x, -p.y}); };
    shape.text = "<svg><path d=\"M" + flipped(controls[0]) + "Q" + flipped(controls[1]) + " " +
                 flipped(controls[2]) + "\"/></svg>";
    return shape;
  }

  /// A cubic of SVG, or one span or several of a rational B-spline of DXF. It goes to the right all
  /// the way, so that it does not cross itself.
  Shape spline(bool is_path) {
    const std::size_t spans = is_path ? 1 : static_cast<std::size_t>(random_.between(1, 4));
    const std::size_t n = spans + 3;
    std::vector<Point> controls;
    Rational x = number(-50, 0);
    for (std::size_t i = 0; i < n; ++i) {
      controls.push_back({x, number(-40, 40)});
      x = x + number(i % 2 == 0 ? 0 : 1, 20);
    }
    std::vector<Rational> weights(n, 1);
    if (!is_path) {
      for (Rational& weight : weights) weight = number(0.5, 2);
    }
    std::vector<Rational> knots(4, 0);
    for (std::size_t i = 1; i < spans; ++i) knots.push_back(knots.back() + number(0.5, 2));
    const Rational last = knots.back() + number(0.5, 2);
    knots.insert(knots.end(), 4, last);
    Shape shape;
    shape.convex = false;
    sample(shape, [&](const Rational& t) { return at(controls, weights, knots, last * t); });
    if (is_path) {
      const auto flipped = [](const Point& p) { return text_of(Point{p.x, -p.y}); };
      shape.text = "<svg><path d=\"M" + flipped(controls[0]) + "C" + flipped(controls[1]) + " " +
                   flipped(controls[2]) + " " + flipped(controls[3]) + "\"/></svg>";
      return shape;
    }
    std::string entity =
        "SPLINE\n70\n4\n71\n3\n72\n" + std::to_string(knots.size()) + "\n73\n" + std::to_string(n);
    for (const Rational& knot : knots) entity += "\n40\n" + text_of(knot);
    for (const Rational& weight : weights) entity += "\n41\n" + text_of(weight);
    for (const Point& p : controls) entity += "\n10\n" + text_of(p.x) + "\n20\n" + text_of(p.y);
    const auto ends = "\n0\nLINE\n10\n" + text_of(controls.back().x) + "\n20\n" +
                      text_of(controls.back().y) + "\n11\n" + text_of(controls[0].x) + "\n21\n" +
                      text_of(controls[0].y);
    shape.text = dxf(entity + ends);
    return shape;
  }

 private:
  static std::string dxf(const std::string& entities) {
    return "0\nSECTION\n2\nENTITIES\n0\n" + entities + "\n0\nENDSEC\n0\nEOF\n";
  }
  /// Takes points of a curve, which at(t) returns for t from 0 to 1. The polyline of twice as many
  /// points moves by about a quarter of the sag.
  template <class At>
  static void sample(Shape& shape, At at) {
    constexpr int kPoints = 400;
    shape.on_curve = {at(Rational(0))};
    double off = 0;
    for (int i = 1; i <= kPoints; ++i) {
      const Near before = near(shape.on_curve.back());
      const Near between = near(at(Rational(2 * i - 1, 2 * kPoints)));
      shape.on_curve.push_back(at(Rational(i, kPoints)));
      off = std::max(off, distance(between, before, near(shape.on_curve.back())));
    }
    shape.sag = 2 * off;
  }
  /// Points of an arc are at most as far apart as the longest chord; its circle has this radius,
  /// and no arc of an ellipse is more curved than that of a circle so many times smaller.
  static void set_sag(Shape& shape, double radius, double curvature) {
    double longest = 0;
    for (std::size_t i = 1; i < shape.on_curve.size(); ++i) {
      const Near a = near(shape.on_curve[i - 1]), b = near(shape.on_curve[i]);
      longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
    }
    shape.sag = longest * longest / (4 * radius) * curvature * curvature;
  }
  /// Evaluates a B-spline of degree 3 by de Boor's algorithm, exactly.
  static Point at(const std::vector<Point>& controls, const std::vector<Rational>& weights,
                  const std::vector<Rational>& knots, const Rational& t) {
    std::size_t span = 3;
    while (span + 1 < controls.size() && knots[span + 1] <= t) ++span;
    struct Weighted {
      Rational x, y, w;
    };
    std::vector<Weighted> d;
    for (std::size_t j = 0; j <= 3; ++j) {
      const std::size_t i = span - 3 + j;
      d.push_back({weights[i] * controls[i].x, weights[i] * controls[i].y, weights[i]});
    }
    for (std::size_t r = 1; r <= 3; ++r) {
      for (std::size_t j = 3; j >= r; --j) {
        const Rational& low = knots[j + span - 3];
        const Rational f = (t - low) / (knots[j + 1 + span - r] - low), g = Rational(1) - f;
        d[j] = {g * d[j - 1].x + f * d[j].x, g * d[j - 1].y + f * d[j].y,
                g * d[j - 1].w + f * d[j].w};
      }
    }
    return {d[3].x / d[3].w, d[3].y / d[3].w};
  }

  Random& random_;
};

template <class Test>
void for_random_cases(int default_count, Test test) {
  const std::uint64_t first = test::seed_from_environment(1);
  const auto count = static_cast<std::uint64_t>(test::count_from_environment(default_count));
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    test(random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Drawings, ArcsLieOnTheirSideWithinTheTolerance) {
  for_random_cases(150, [](Random& random) {
    Curves curves(random);
    const Shape shape = curves.bulge();
    check(shape, curves.tolerance(), 23);
    const Shape other = curves.arc();
    check(other, curves.tolerance(), 23);
  });
}

TEST(Drawings, EllipsesLieOnTheirSideWithinTheTolerance) {
  for_random_cases(100, [](Random& random) {
    Curves curves(random);
    const Shape shape = curves.ellipse();
    check(shape, curves.tolerance(), 31);
  });
}

TEST(Drawings, SplinesLieOnTheirSideWithinTheTolerance) {
  for_random_cases(100, [](Random& random) {
    Curves curves(random);
    const Shape path = curves.spline(true);
    check(path, curves.tolerance(), 41);
    const Shape spline = curves.spline(false);
    check(spline, curves.tolerance(), 41);
  });
}

TEST(Drawings, HairpinsLieOnTheirSideWithinTheTolerance) {
  for_random_cases(200, [](Random& random) {
    Curves curves(random);
    const Shape shape = curves.hairpin();
    check(shape, curves.tolerance(), 41);
  });
}

}  // namespace
}  // namespace minksum

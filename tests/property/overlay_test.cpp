// Fill rules and boolean operations on random input that is as degenerate as it gets.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "property/sums.hpp"
#include "reference/brute_force_overlay.hpp"
#include "reference/validity.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;
using reference::brute_force_boolean;
using reference::brute_force_resolve;
using reference::brute_force_unite;

constexpr std::array kRules = {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                               FillRule::kPositive, FillRule::kNegative};

std::string text_of(const Geometry& geometry) {
  std::string text = to_text(geometry.region);
  const auto add = [&](const std::vector<Point>& points) {
    for (const Point& p : points) {
      text += ' ';
      text += p.x.to_string();
      text += ' ';
      text += p.y.to_string();
    }
  };
  for (const Polyline& line : geometry.polylines) {
    text += "\nLINE";
    add(line);
  }
  if (!geometry.points.empty()) text += "\nPOINTS";
  add(geometry.points);
  return text;
}

Point random_point(Random& random, int size) {
  const int x = random.between(0, size);
  return {Rational(x), Rational(random.between(0, size))};
}

std::vector<Point> random_points(Random& random, int count, int size) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    // Now and then back to where it came from, or on the spot.
    const bool again = points.size() > 1 && random.one_in(6);
    points.push_back(again ? points[points.size() - 2] : random_point(random, size));
  }
  return points;
}

/// Rings, paths and points at random on a small grid, where nearly everything coincides.
Geometry random_mess(Random& random) {
  Geometry mess;
  const int size = random.between(1, 6);
  for (int polygons = random.between(0, 3); polygons > 0; --polygons) {
    mess.region.begin_polygon();
    for (int rings = random.between(1, 2); rings > 0; --rings) {
      mess.region.begin_ring();
      for (const Point& p : random_points(random, random.between(1, 7), size)) {
        mess.region.add_vertex(p.x, p.y);
      }
    }
  }
  if (random.one_in(2)) mess.polylines.push_back(random_points(random, random.between(2, 5), size));
  if (random.one_in(3)) mess.points = random_points(random, random.between(1, 3), size);
  return mess;
}

Geometry resolved(const Geometry& geometry, FillRule rule, bool regularize = false) {
  ResolveOptions options;
  options.fill = rule;
  options.regularize = regularize;
  return resolve(geometry, options);
}

Geometry transformed(const Geometry& geometry, const std::function<Point(const Point&)>& f) {
  Geometry result{test::transformed(geometry.region, f), {}, {}};
  for (const Polyline& line : geometry.polylines) {
    Polyline& moved = result.polylines.emplace_back();
    for (const Point& p : line) moved.push_back(f(p));
  }
  for (const Point& p : geometry.points) result.points.push_back(f(p));
  return result;
}

/// Scales and moves along the axes, which changes no order: to large integers, decimals, and doubles
/// far apart.
std::function<Point(const Point&)> random_scaling(Random& random) {
  const int kind = random.below(5);
  const std::int64_t seed = random.between(1, 1000);
  const auto power = [](int exponent) { return Rational(std::ldexp(1.0, exponent)); };
  return [=](const Point& p) -> Point {
    switch (kind) {
      case 0: return p;
      case 1: return {p.x * Rational((std::int64_t{1} << 56) + seed), p.y * Rational(seed)};
      case 2: return {p.x * Rational(Decimal{seed, -7}) + 1, p.y * Rational(Decimal{3, -2}) - 5};
      case 3: return {p.x * power(70) + power(-30), p.y * power(-40)};
      default: return {p.x * power(900), p.y * power(-900)};
    }
  };
}
/// A projective map: lines stay lines, and every point gets a denominator of its own.
std::function<Point(const Point&)> random_projection(Random& random) {
  const int seed = random.between(1, 1000);
  return [=](const Point& p) -> Point {
    const Rational w = p.x * 3 + p.y * 5 + seed;
    return {p.x / w, p.y / w};
  };
}

struct Case {
  Geometry mess;
  FillRule rule = FillRule::kAutomatic;
  bool regularize = false;
};
Case random_case(Random& random) {
  Case c{random_mess(random), {}, random.one_in(4)};
  c.rule = kRules[static_cast<std::size_t>(random.below(kRules.size()))];
  return c;
}
Geometry resolved(const Case& c) { return resolved(c.mess, c.rule, c.regularize); }
std::string note(int number, const Case& c) {
  return "case " + std::to_string(number) + ", " + to_string(c.rule) +
         (c.regularize ? ", regularized\n" : "\n") + text_of(c.mess);
}
Random random_of_case(int number) {
  return Random(seed_from_environment(1) * 1000003 + static_cast<std::uint64_t>(number));
}

TEST(Overlay, ResolveIsAsByBruteForce) {
  const int count = count_from_environment(1000);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    const Case c = random_case(random);
    SCOPED_TRACE(note(i, c));
    const Geometry expected = brute_force_resolve(c.mess, c.rule, c.regularize);
    const Geometry result = resolved(c);
    EXPECT_EQ(text_of(result), text_of(expected));
    EXPECT_EQ(reference::canonical_fault(result.region), "");
    EXPECT_EQ(text_of(resolved(result, FillRule::kAutomatic)), text_of(result));
    EXPECT_EQ(text_of(resolved(result, FillRule::kStrict)), text_of(result));
    const auto map = random_scaling(random);
    const Geometry scaled = resolved({transformed(c.mess, map), c.rule, c.regularize});
    EXPECT_EQ(text_of(scaled), text_of(transformed(expected, map)));
  }
}

TEST(Overlay, ResolveOfFractionsIsAsByBruteForce) {
  const int count = count_from_environment(1000) / 10;
  for (int i = 0; i < count && !HasFailure(); ++i) {
    Random random = random_of_case(i);
    Case c = random_case(random);
    c.mess = transformed(c.mess, random_projection(random));
    SCOPED_TRACE(note(i, c));
    EXPECT_EQ(text_of(resolved(c)), text_of(brute_force_resolve(c.mess, c.rule, c.regularize)));
  }
}

}  // namespace

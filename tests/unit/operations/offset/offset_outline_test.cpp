// Tests that the outlines from which offsets are read wind the wrong way nowhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "minksum/boolean.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "operations/offset/outline.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

constexpr std::array kJoins = {Join::kRound, Join::kMiter, Join::kSquare, Join::kBevel};

/// Returns the region with each vertex repeated three times, each moved by up to 50 units.
Region roughened(const Region& region, const Rational& unit, Random& random) {
  const auto jitter = [&] { return Rational(random.between(-50, 50)) * unit; };
  Ring ring;
  for (const Point& p : region.polygon(0).outer) {
    for (int k = 0; k < 3; ++k) ring.push_back({p.x + jitter(), p.y + jitter()});
  }
  return resolve({Region(Polygon{ring, {}}), {}, {}},
                 {.fill = FillRule::kNonZero, .regularize = true})
      .region;
}

/// Returns a long shape, put at an angle, with one side bent, convex or not. The edges of that side
/// are as short as `unit`, and turn by far less than directions on the grid can tell.
Region bent(int bend, const Rational& unit, Random& random) {
  Ring ring{{-1, -9}, {1, -9}};
  for (int k = 100; k >= -100; --k) {
    const Rational x = Rational(k) * unit;
    ring.push_back({x, Rational(-bend, 8) * x * x});
  }
  const Affine turn = Affine::rotation(Rational(random.between(-99, 99), 100));
  return resolve({transform(Region(Polygon{ring, {}}), turn), {}, {}}).region;
}

OffsetOptions with(Join join, Cap cap) {
  OffsetOptions options;
  options.join = join;
  options.cap = cap;
  options.miter_limit = 3;
  return options;
}

Geometry negative(const Region& outlines) {
  return resolve({outlines, {}, {}}, {.fill = FillRule::kNegative, .regularize = true});
}

Region outlines_of(const Region& region, bool inwards, const Corners& corners) {
  Region outlines;
  for (std::size_t ring = 0; ring < region.ring_count(); ++ring) {
    std::vector<Point> path;
    for (const std::size_t v : region.vertices_of(ring)) path.push_back(region.point(v));
    if (inwards) std::reverse(path.begin(), path.end());
    Cancellation never;
    add_outline(path, {}, corners, never, outlines);
  }
  return outlines;
}

void expect_no_wrong_way(const Region& region, const Rational& d) {
  for (const Join join : kJoins) {
    const Corners corners(d, d / Rational(10), with(join, Cap::kRound));
    const std::string message =
        std::string(to_string(join)) + ' ' + d.to_string() + ' ' + test::to_text(region);
    const Region outwards = outlines_of(region, false, corners);
    EXPECT_TRUE(negative(outwards).empty()) << message;
    EXPECT_TRUE(contains(region, negative(outlines_of(region, true, corners)).region)) << message;
  }
}

// Edges range from much longer than the step of the grid (at most d/640 here) to far below it.
TEST(OffsetOutline, NeverWindsTheWrongWay) {
  Random random(test::seed_from_environment(7));
  for (int i = 0; i < test::count_from_environment(15); ++i) {
    const Rational unit(Decimal{1, -3 - i % 5});
    const Region region = roughened(test::random_polygon(random), unit, random);
    const Rational d(random.between(1, 30), 8);
    expect_no_wrong_way(region, d);
    expect_no_wrong_way(bent(i % 2 == 0 ? 1 : -1, unit, random), d);
  }
}

TEST(OffsetOutline, NeverWindsTheWrongWayAroundPolylines) {
  Random random(test::seed_from_environment(8));
  for (int i = 0; i < test::count_from_environment(15); ++i) {
    const Rational unit(Decimal{1, -3 - i % 5});
    std::vector<Point> path;
    for (const Point& p : test::random_simple_polyline(random, 6, 20)) {
      for (int k = 0; k < 3; ++k) {
        path.push_back({p.x + Rational(random.between(-50, 50)) * unit,
                        p.y + Rational(random.between(-50, 50)) * unit});
      }
    }
    const std::array<std::size_t, 2> ends{0, path.size() - 1};
    for (std::size_t k = path.size() - 1; k-- > 1;) path.push_back(path[k]);
    const auto repeated = std::adjacent_find(path.begin(), path.end());
    if (repeated != path.end()) continue;
    const Rational d(random.between(1, 30), 8);
    for (const Join join : kJoins) {
      for (const Cap cap : {Cap::kRound, Cap::kButt, Cap::kSquare}) {
        Region outlines;
        Cancellation never;
        add_outline(path, ends, Corners(d, d / Rational(10), with(join, cap)), never, outlines);
        EXPECT_TRUE(negative(outlines).empty()) << to_string(join) << ' ' << to_string(cap);
      }
    }
  }
}

}  // namespace
}  // namespace minksum

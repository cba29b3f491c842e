// Tests that a box less a region has the region's own rings wherever they are the answer.
#include "overlay/complement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "support/generators.hpp"
#include "support/messes.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

Region as_region(const Box& box) {
  return Region(Polygon{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}});
}
Box box_of(int x0, int y0, int x1, int y1) {
  return {{Rational(x0), Rational(y0)}, {Rational(x1), Rational(y1)}};
}
Box widened(const Box& box, const Rational& by) {
  return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}};
}
Region canonical(const Region& region) { return resolve({region, {}, {}}).region; }

/// Expects the right difference; returns whether the rings were enough.
bool expect_difference(const Box& box, const Region& region, const std::string& what) {
  const Region whole = as_region(box);
  // This difference comes from the overlay alone.
  const Region expected = symmetric_difference(whole, intersect(whole, region));
  EXPECT_EQ(subtract(whole, region), expected) << what;
  const auto result = complement_in(box, region);
  if (result) {
    EXPECT_EQ(*result, expected) << what;
    EXPECT_FALSE(result->has_origins());
  }
  return result.has_value();
}

TEST(Complement, SumsInsideOfIt) {
  Random random(1);
  int sums = 0;
  int turned = 0;
  for (int i = 0; i < 400; ++i) {
    const test::Pair pair = test::random_pair(random);
    const Region sum = minkowski_sum(pair.p, pair.q);
    const auto around = bounding_box(sum);
    if (!around) continue;
    const Rational by(1 + random.between(0, 40), 1 + random.between(0, 9));
    turned += expect_difference(widened(*around, by), sum, test::to_text(pair.p)) ? 1 : 0;
    ++sums;
  }
  EXPECT_GT(turned, sums / 2);
  EXPECT_LT(turned, sums);
}

// The coordinates are fractions without a common denominator, and numbers of 53 bits and more.
TEST(Complement, CrossingsAsVertices) {
  Random random(2);
  int turned = 0;
  for (int i = 0; i < 60; ++i) {
    Region p = test::random_with_holes(random, 120, 5);
    Region q = test::random_two_opt(random, 12, 20);
    if (i % 3 == 1) {
      p = transform(p, Affine::scaling(Rational(1, 3)));
      q = transform(q, Affine::scaling(Rational(1, 7)));
    }
    if (i % 3 == 2) p = transform(p, Affine::translation(Rational(1e9 + 0.1), Rational(-3e8)));
    const Region sum = minkowski_sum(p, q);
    turned +=
        expect_difference(widened(*bounding_box(sum), Rational(5)), sum, test::to_text(p)) ? 1 : 0;
  }
  EXPECT_GT(turned, 55);
}

// The region is a ring around the box, with islands in its holes.
TEST(Complement, Frames) {
  Random random(3);
  int turned = 0;
  for (int i = 0; i < 80; ++i) {
    const Region room = test::random_with_holes(random, 80, 3);
    const Box box = widened(*bounding_box(room), Rational(30));
    const Region frame = subtract(as_region(widened(box, Rational(60))), room);
    const Region walls = minkowski_sum(frame, test::random_two_opt(random, 9, 12));
    turned += expect_difference(box, walls, test::to_text(room)) ? 1 : 0;
  }
  EXPECT_GT(turned, 60);
}

TEST(Complement, IslandsInHoles) {
  // Squares lie around squares in two groups, and are listed in no helpful order.
  std::vector<std::vector<test::Outline>> polygons;
  for (const int x : {0, 100}) {
    for (const int k : {0, 2, 4}) {
      const int a = 5 * k;
      const int b = 90 - a;
      const int c = a + 5;
      const int d = b - 5;
      polygons.push_back({{{x + a, a}, {x + b, a}, {x + b, b}, {x + a, b}},
                          {{x + c, c}, {x + c, d}, {x + d, d}, {x + d, c}}});
    }
  }
  const Region region = canonical(test::make_region(polygons));
  ASSERT_EQ(region.ring_count(), 12U);
  EXPECT_TRUE(expect_difference(box_of(-1, -1, 200, 100), region, "squares"));
}

// Where rings touch, the complement has other rings.
TEST(Complement, WhatTouches) {
  const Box box = box_of(-10, -10, 60, 60);
  const Region corner = canonical(test::make_region(
      {{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, {{{10, 10}, {20, 10}, {20, 20}, {10, 20}}}}));
  EXPECT_FALSE(expect_difference(box, corner, "two squares with a corner in common"));
  const Region on_edge = canonical(
      test::make_region({{{{0, 0}, {30, 0}, {30, 5}, {0, 5}}}, {{{10, 5}, {20, 15}, {0, 15}}}}));
  EXPECT_FALSE(expect_difference(box, on_edge, "a corner on an edge"));
  const Region hole = canonical(
      test::make_polygon({{0, 0}, {30, 0}, {30, 30}, {0, 30}}, {{{0, 15}, {10, 20}, {10, 10}}}));
  EXPECT_FALSE(expect_difference(box, hole, "a hole that touches its outer ring"));
  EXPECT_FALSE(expect_difference(box_of(0, -10, 60, 60), hole, "an edge on the box"));
  EXPECT_FALSE(expect_difference(box_of(5, 5, 25, 60), hole, "a box that cuts"));
  EXPECT_FALSE(expect_difference(box_of(100, 100, 120, 120), hole, "a box elsewhere"));
  EXPECT_FALSE(expect_difference(box_of(2, 2, 6, 6), hole, "a box that is all covered"));
  EXPECT_FALSE(expect_difference(box, {}, "nothing"));
}

// The rings are so close that doubles cannot tell; exact numbers do.
TEST(Complement, HairsApart) {
  const Rational hair(1, std::int64_t{1} << 62);
  const Region left = test::make_polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (const Rational& gap : {hair, -hair, Rational(0), Rational(1, 1000)}) {
    const Region right = transform(test::make_polygon({{0, 4}, {9, 0}, {9, 9}}),
                                   Affine::translation(Rational(10) + gap, Rational(0)));
    const Region both = unite(left, right);
    EXPECT_EQ(expect_difference(box_of(-3, -3, 30, 30), both, "a hair"), gap.sign() != 0);
  }
  const Region square = test::rectangle(0, 0, 10, 10);
  EXPECT_TRUE(expect_difference(widened(*bounding_box(square), hair), square, "a hair's margin"));
}

// Comparing all pairs of edges, or of rings, would take long.
TEST(Complement, LongLists) {
  // The edges lie one above the other.
  test::Outline comb;
  for (int i = 0; i < 250; ++i) {
    for (const auto& at :
         {test::Vertex{1000, 4 * i}, {1000 - i % 7, 4 * i + 1}, {1, 4 * i + 2}, {2, 4 * i + 3}}) {
      comb.push_back(at);
    }
  }
  comb.push_back({0, 1000});
  comb.push_back({0, -1});
  const Region teeth = canonical(test::make_polygon(comb));
  EXPECT_TRUE(expect_difference(box_of(-9, -9, 2000, 2000), teeth, "a comb"));
  // The islands lie in a hole.
  const Region hole = test::round_polygon(2000, 100'000);
  Polygon around{
      {{-200'000, -200'000}, {200'000, -200'000}, {200'000, 200'000}, {-200'000, 200'000}},
      {hole.polygon(0).outer}};
  std::vector<Polygon> polygons{around};
  for (int i = 0; i < 900; ++i) {
    const int x = -30'000 + 2000 * (i % 30);
    const int y = -30'000 + 2000 * (i / 30);
    polygons.push_back({{{x, y}, {x + 900, y}, {x, y + 900}}, {}});
  }
  const Region islands = canonical(Region(std::span<const Polygon>(polygons)));
  EXPECT_TRUE(expect_difference(box_of(-300'000, -300'000, 300'000, 300'000), islands, "islands"));
}

// Rings may have any direction, any first vertex and any order.
TEST(Complement, ValidRegions) {
  Random random(6);
  int turned = 0;
  for (int i = 0; i < 100; ++i) {
    const Region shape =
        minkowski_sum(test::random_with_holes(random, 60, 3), test::random_two_opt(random, 9, 9));
    std::vector<Polygon> polygons;
    for (const int x : {1000, -1000, 0}) {
      const Region moved = transform(shape, Affine::translation(Rational(x), Rational(0)));
      for (const std::size_t p : moved.polygons()) polygons.push_back(moved.polygon(p));
    }
    for (Polygon& polygon : polygons) {
      polygon.holes.push_back(polygon.outer);
      for (Ring& ring : polygon.holes) {
        if (random.one_in(2)) std::reverse(ring.begin(), ring.end());
        std::rotate(ring.begin(), ring.begin() + random.between(0, 2), ring.end());
      }
      polygon.outer = polygon.holes.back();
      polygon.holes.pop_back();
      std::reverse(polygon.holes.begin(), polygon.holes.end());
    }
    const Region region{std::span<const Polygon>(polygons)};
    turned += expect_difference(widened(*bounding_box(region), Rational(3)), region, "") ? 1 : 0;
  }
  EXPECT_GT(turned, 50);
  // The result has no straight or repeated vertices.
  const Box box = box_of(-1, -1, 12, 12);
  const Region straight = test::make_polygon({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}});
  EXPECT_FALSE(expect_difference(box, straight, "a straight vertex"));
  const Region twice = test::make_polygon({{0, 0}, {10, 0}, {10, 0}, {10, 10}, {0, 10}});
  EXPECT_FALSE(expect_difference(box, twice, "a repeated vertex"));
}

// Boxes may start at any corner, in either direction; other polygons are not boxes.
TEST(Complement, OfAnyBox) {
  const Region square = test::rectangle(2, 2, 4, 4);
  test::Outline box{{0, 0}, {9, 0}, {9, 6}, {0, 6}};
  const Region expected = canonical(
      test::make_polygon({{0, 0}, {9, 0}, {9, 6}, {0, 6}}, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}));
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(subtract(test::make_polygon(box), square), expected) << i;
    std::rotate(box.begin(), box.begin() + 1, box.end());
    if (i == 3) std::reverse(box.begin(), box.end());
  }
  const Region slanted = test::make_polygon({{0, 0}, {9, 1}, {9, 6}, {0, 6}});
  EXPECT_EQ(subtract(slanted, square), symmetric_difference(slanted, square));
}

TEST(Complement, AnyMagnitude) {
  Random random(4);
  const Region shape =
      minkowski_sum(test::random_with_holes(random, 60, 3), test::random_two_opt(random, 9, 9));
  for (const int exponent : {-400, -200, -100, -20, 20, 100, 200, 400}) {
    const Region scaled = test::scaled(shape, Rational(Decimal{1, exponent}));
    const Box box = *bounding_box(scaled);
    expect_difference(widened(box, box.max.x - box.min.x), scaled,
                      "times ten to " + std::to_string(exponent));
  }
}

TEST(Complement, AnyMess) {
  Random random(5);
  for (int i = 0; i < 1500; ++i) {
    const Region region = resolve(test::random_mess(random)).region;
    if (region.empty()) continue;
    const Box around = *bounding_box(region);
    expect_difference(widened(around, Rational(random.between(0, 3), 2)), region,
                      test::to_text(region));
    const Rational a(random.between(-5, 15));
    const Rational b(random.between(-5, 15));
    expect_difference(
        {{a, b}, {a + Rational(1 + random.between(0, 9)), b + Rational(1 + random.between(0, 9))}},
        region, test::to_text(region));
  }
}

}  // namespace
}  // namespace minksum

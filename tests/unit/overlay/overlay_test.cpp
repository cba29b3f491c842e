// Tests fill rules, boolean operations and point location on shapes that one can draw.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "minksum/boolean.hpp"
#include "minksum/error.hpp"
#include "minksum/locate.hpp"
#include "minksum/measure.hpp"
#include "minksum/resolve.hpp"
#include "support/messes.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;
using test::make_polygon;
using test::make_region;
using test::rectangle;

Geometry resolved(const Region& region, FillRule rule = FillRule::kAutomatic,
                  bool regularize = false) {
  Options options;
  options.fill = rule;
  options.regularize = regularize;
  return resolve({region, {}, {}}, options);
}

Point vertex(const Rational& x, const Rational& y) { return {x, y}; }

TEST(Resolve, BowTieCrossesAtAFraction) {
  const Region bow_tie = make_polygon({{0, 0}, {3, 2}, {3, 0}, {0, 1}});
  const Geometry result = resolved(bow_tie);
  ASSERT_EQ(result.region.polygon_count(), 2U);
  EXPECT_EQ(result.region.polygon(0).outer[1], vertex(1, Rational(2, 3)));
  EXPECT_FALSE(result.has_thin_parts());
  EXPECT_EQ(resolved(bow_tie, FillRule::kEvenOdd), result);
}

TEST(Resolve, PentagramByRule) {
  const Region star = make_polygon({{0, 30}, {18, -24}, {-29, 9}, {29, 9}, {-18, -24}});
  const Region hull = resolved(star, FillRule::kNonZero).region;
  EXPECT_EQ(hull.hole_count(), 0U);
  EXPECT_EQ(hull.vertex_count(), 10U);
  EXPECT_EQ(resolved(star, FillRule::kEvenOdd).region.polygon_count(), 5U);
  EXPECT_EQ(resolved(star, FillRule::kNegative).region, hull);  // it runs clockwise
  const Geometry positive = resolved(star, FillRule::kPositive);
  EXPECT_TRUE(positive.region.empty());
  EXPECT_TRUE(positive.has_thin_parts());  // the ring's own points
  EXPECT_TRUE(resolved(star, FillRule::kPositive, true).empty());
}

TEST(Resolve, SpikesAndCollapsedRings) {
  // The square has an antenna outwards, one into its inside, and a ring that is a segment.
  const Region region = make_region(
      {{{{0, 0}, {2, 0}, {2, 1}, {4, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {1, 2}, {0, 2}}},
       {{{7, 0}, {9, 0}, {8, 0}}},
       {{{5, 5}, {5, 5}}}});
  const Geometry result = resolved(region);
  EXPECT_EQ(result.region, rectangle(0, 0, 2, 2));
  ASSERT_EQ(result.polylines.size(), 2U);
  EXPECT_EQ(result.polylines[0], (Polyline{{2, 1}, {4, 1}}));
  EXPECT_EQ(result.polylines[1], (Polyline{{7, 0}, {9, 0}}));
  EXPECT_EQ(result.points, (std::vector<Point>{{5, 5}}));
  const Geometry regular = resolved(region, FillRule::kAutomatic, true);
  EXPECT_EQ(regular.region, result.region);
  EXPECT_FALSE(regular.has_thin_parts());
}

TEST(Resolve, AntennaThroughAHole) {
  const Region region = make_polygon({{0, 0}, {6, 0}, {6, 3}, {-1, 3}, {6, 3}, {6, 6}, {0, 6}},
                                     {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}});
  const Geometry result = resolved(region);
  EXPECT_EQ(result.region.hole_count(), 1U);
  // The hole takes away the part of the antenna that is inside it.
  EXPECT_EQ(result.polylines, (std::vector<Polyline>{{{-1, 3}, {0, 3}}}));
  // By winding numbers, a ring's own points belong to the set wherever they are.
  const Geometry wound = resolved(region, FillRule::kEvenOdd);
  EXPECT_EQ(wound.polylines, (std::vector<Polyline>{{{-1, 3}, {0, 3}}, {{2, 3}, {4, 3}}}));
}

// -- The automatic rule for polygons that are not valid ------------------------------------------

TEST(Holes, OneThatCrossesItsOuterRingTakesAwayOnly) {
  const Region region =
      make_polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{4, 2}, {9, 2}, {9, 4}, {4, 4}}});
  const Region expected =
      make_polygon({{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 4}, {6, 4}, {6, 6}, {0, 6}});
  EXPECT_EQ(resolved(region), (Geometry{expected, {}, {}}));
  EXPECT_EQ(resolved(region, FillRule::kAutomatic, true), (Geometry{expected, {}, {}}));
}

TEST(Holes, OneOutsideOfItsOuterRingTakesNothing) {
  const Region outer = rectangle(0, 0, 6, 6);
  EXPECT_EQ(resolved(make_polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{8, 0}, {9, 0}, {9, 9}}})),
            (Geometry{outer, {}, {}}));
}

TEST(Holes, TwoThatOverlapTakeTheirUnion) {
  const Region region =
      make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {5, 1}, {5, 5}, {1, 5}},
                                                      {{3, 3}, {7, 3}, {7, 7}, {3, 7}},
                                                      {{4, 4}, {5, 4}, {5, 5}, {4, 5}}});
  const Region expected =
      make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                   {{{1, 1}, {1, 5}, {3, 5}, {3, 7}, {7, 7}, {7, 3}, {5, 3}, {5, 1}}});
  EXPECT_EQ(resolved(region), (Geometry{expected, {}, {}}));
}

TEST(Holes, WhatTheyLeaveBetweenThemStays) {
  // Two holes share an edge, which is a wall without width. One is wider than the outer ring.
  const Region region =
      make_polygon({{0, 0}, {9, 0}, {9, 6}, {0, 6}},
                   {{{1, 1}, {4, 1}, {4, 9}, {1, 9}}, {{4, 1}, {8, 1}, {8, 5}, {4, 5}}});
  const Geometry result = resolved(region);
  EXPECT_EQ(result.polylines, (std::vector<Polyline>{{{4, 1}, {4, 5}}}));
  EXPECT_EQ(result.region,
            make_polygon(
                {{0, 0}, {9, 0}, {9, 6}, {4, 6}, {4, 5}, {8, 5}, {8, 1}, {1, 1}, {1, 6}, {0, 6}}));
}

TEST(Holes, ASpikeOfAHoleIntoItIsAWall) {
  const Region region = make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                                     {{{1, 1}, {4, 1}, {4, 3}, {4, 1}, {8, 1}, {8, 8}, {1, 8}}});
  EXPECT_EQ(resolved(region).polylines, (std::vector<Polyline>{{{4, 1}, {4, 3}}}));
  EXPECT_EQ(resolved(region).region.hole_count(), 1U);
}

TEST(Holes, ABowTieHasTwoPartsToTakeAway) {
  // The halves of the bow tie wind in opposite directions; another hole covers one of them.
  const Region region = make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                                     {{{1, 1}, {7, 5}, {7, 1}, {1, 5}}, {{1, 1}, {4, 3}, {1, 5}}});
  const Geometry result = resolved(region);
  EXPECT_FALSE(result.has_thin_parts());
  EXPECT_EQ(area(result.region), Rational(81 - 12));
}

TEST(Holes, EachIsOfItsOwnPolygon) {
  // The hole of the first polygon takes nothing from the second, which lies over it.
  const Region region =
      make_region({{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {5, 1}, {5, 5}, {1, 5}}},
                   {{{2, 2}, {9, 2}, {9, 4}, {2, 4}}}});
  EXPECT_EQ(area(resolved(region).region), Rational(36 - 16 + 6 + 6));
  // The bow tie is there twice, in both directions, so the winding numbers cancel.
  const Region ties = make_region({{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}},
                                   {{{0, 4}, {4, 0}, {4, 4}, {0, 0}}},
                                   {{{8, 8}, {9, 8}, {9, 9}}}});
  EXPECT_EQ(area(resolved(ties).region), Rational(17, 2));
}

TEST(Holes, AnOuterRingThatItsHoleFillsIsALine) {
  const Region region =
      make_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const Geometry result = resolved(region);
  EXPECT_TRUE(result.region.empty());
  EXPECT_EQ(result.polylines, (std::vector<Polyline>{{{0, 0}, {0, 4}, {4, 4}, {4, 0}, {0, 0}}}));
  EXPECT_TRUE(resolved(region, FillRule::kAutomatic, true).empty());
}

TEST(Resolve, PolylinesAndPoints) {
  Geometry geometry;
  geometry.polylines = {{{0, 0}, {1, 0}, {2, 0}, {2, 2}},
                        {{2, 2}, {0, 2}, {0, 0}},
                        {{9, 0}, {5, 0}},
                        {{7, -1}, {7, 1}},
                        {{3, 3}, {3, 3}}};
  geometry.points = {{8, 0}, {2, 1}, {4, 4}, {4, 4}};
  const Geometry result = resolve(geometry);
  const std::vector<Polyline> expected = {
      {{0, 0}, {0, 2}, {2, 2}, {2, 0}, {0, 0}},  // closed, towards the smaller neighbour
      {{5, 0}, {7, 0}},
      {{7, -1}, {7, 0}},
      {{7, 0}, {7, 1}},
      {{7, 0}, {9, 0}}};
  EXPECT_EQ(result.polylines, expected);
  EXPECT_EQ(result.points, (std::vector<Point>{{3, 3}, {4, 4}}));
}

TEST(Resolve, StrictNamesThePlace) {
  EXPECT_NO_THROW(resolved(rectangle(0, 0, 1, 1), FillRule::kStrict));
  try {
    resolved(make_region({{{{0, 0}, {1, 0}, {0, 1}}}, {{{5, 0}, {8, 2}, {8, 0}, {5, 1}}}}),
             FillRule::kStrict);
    FAIL() << "a bow tie was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.culprit().polygon, 1U);
    EXPECT_NE(error.culprit().vertex, Culprit::kNone);
  }
}

TEST(Resolve, AnyMagnitude) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  const double huge = 1.7e308;
  const double tiny = 5e-324;
  for (const auto& [x, y] : {std::pair{-huge, -huge}, {huge, tiny}, {huge, -huge}, {-huge, huge}}) {
    region.add_vertex(x, y);
  }
  const Geometry result = resolved(region);
  EXPECT_EQ(result.region.polygon_count(), 2U);
  EXPECT_EQ(resolved(result.region, FillRule::kStrict), result);
}

TEST(Resolve, Cancelled) {
  Options options;
  options.cancel.emplace();
  options.cancel->cancel();
  try {
    (void)resolve({rectangle(0, 0, 1, 1), {}, {}}, options);
    FAIL() << "it went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

TEST(Resolve, NamesOfRules) {
  EXPECT_STREQ(to_string(FillRule::kEvenOdd), "evenodd");
  EXPECT_STREQ(to_string(FillRule::kStrict), "strict");
}

TEST(Boolean, TwoSquares) {
  const Region a = rectangle(0, 0, 2, 2);
  const Region b = rectangle(1, 1, 3, 3);
  EXPECT_EQ(intersect(a, b), rectangle(1, 1, 2, 2));
  EXPECT_EQ(area(unite(a, b)), 7);
  EXPECT_EQ(subtract(a, b), make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  EXPECT_EQ(symmetric_difference(a, b).polygon_count(), 2U);
  EXPECT_TRUE(contains(a, rectangle(0, 0, 1, 1)));
  EXPECT_FALSE(contains(a, b));
  EXPECT_TRUE(contains(a, Region()));
  EXPECT_TRUE(intersect(a, rectangle(2, 0, 3, 2)).empty());  // a common side has no area
  EXPECT_EQ(unite(a, rectangle(2, 0, 3, 2)), rectangle(0, 0, 3, 2));
}

TEST(Boolean, HolesAndIslands) {
  const Region frame =
      make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {6, 3}, {6, 6}, {3, 6}}});
  const Region rest = subtract(rectangle(0, 0, 9, 9), frame);
  EXPECT_EQ(rest, rectangle(3, 3, 6, 6));
  EXPECT_EQ(unite(frame, rest), rectangle(0, 0, 9, 9));
  const Region island = unite(frame, rectangle(4, 4, 5, 5));
  EXPECT_EQ(island.polygon_count(), 2U);
  EXPECT_EQ(symmetric_difference(rectangle(0, 0, 9, 9), rest), unite(frame, frame));
}

TEST(Boolean, UnionOfThinAndThick) {
  const std::vector<Geometry> all = {{rectangle(0, 0, 2, 2), {}, {}},
                                     {{}, {{{-1, 1}, {5, 1}}}, {{1, 1}, {5, 5}}},
                                     {rectangle(4, 0, 6, 2), {}, {}}};
  const Geometry result = unite(all);
  EXPECT_EQ(result.region.polygon_count(), 2U);
  EXPECT_EQ(result.polylines, (std::vector<Polyline>{{{-1, 1}, {0, 1}}, {{2, 1}, {4, 1}}}));
  EXPECT_EQ(result.points, (std::vector<Point>{{5, 5}}));
}

// Where many sets overlap, they are united in groups.
TEST(Boolean, UnionOfManyIsThatOfAllAtOnce) {
  Options positive;
  positive.fill = FillRule::kPositive;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::Random random(seed);
    const int spread = std::array{2, 12, 60}[seed % 3];
    const auto scale = test::random_scaling(random);
    std::vector<Geometry> sets;
    Geometry all;
    for (int i = 0; i < 40; ++i) {
      const Point by{random.between(0, spread), random.between(0, spread)};
      const auto moved = [&](const Point& at) { return scale({at.x * 3 + by.x, at.y * 2 + by.y}); };
      const Geometry set = resolve(test::transformed(test::random_mess(random), moved));
      all.region = test::together(all.region, set.region);
      all.polylines.insert(all.polylines.end(), set.polylines.begin(), set.polylines.end());
      all.points.insert(all.points.end(), set.points.begin(), set.points.end());
      sets.push_back(set);
    }
    EXPECT_EQ(unite(sets), resolve(all, positive)) << seed;
  }
}

TEST(Boolean, UnionOfManyDoesNotMakeBuriedCrossings) {
  std::vector<Region> squares;
  Region all;
  for (int i = 0; i < 300; ++i) {
    const int x = i * 7 % 300;
    squares.push_back(rectangle(x, i, 1000 + x, 1000 + i));
    all = test::together(all, squares.back());
  }
  Options options;
  options.limits.max_crossings = 20000;  // nearly all of the 44,850 pairs of squares cross twice
  EXPECT_EQ(unite(squares, options), resolved(all, FillRule::kPositive).region);
}

TEST(Boolean, ResultsHaveNoOrigins) {
  EXPECT_FALSE(unite(rectangle(0, 0, 2, 2), rectangle(1, 1, 3, 3)).has_origins());
}

TEST(Boolean, OperandsAreReadByTheFillRule) {
  test::Random random(5);
  std::size_t differ = 0;
  for (const FillRule rule : {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                              FillRule::kPositive, FillRule::kNegative}) {
    Options options;
    options.fill = rule;
    for (int i = 0; i < 60; ++i) {
      const Geometry given[] = {test::random_mess(random), test::random_mess(random)};
      const Geometry read[] = {resolve(given[0], options), resolve(given[1], options)};
      EXPECT_EQ(unite(given, options), unite(read));
      const auto& [p, q] = given;
      const auto& [a, b] = read;
      EXPECT_EQ(unite(p.region, q.region, options), unite(a.region, b.region));
      EXPECT_EQ(intersect(p.region, q.region, options), intersect(a.region, b.region));
      EXPECT_EQ(subtract(p.region, q.region, options), subtract(a.region, b.region));
      EXPECT_EQ(symmetric_difference(p.region, q.region, options),
                symmetric_difference(a.region, b.region));
      EXPECT_EQ(contains(p.region, q.region, options), contains(a.region, b.region));
      differ += p.region != a.region;
    }
  }
  EXPECT_GT(differ, 200U);
  // Directions of valid rings mean nothing.
  const Region backwards = make_polygon({{0, 0}, {0, 2}, {2, 2}, {2, 0}});
  const Geometry both[] = {backwards, rectangle(1, 0, 3, 2)};
  EXPECT_EQ(unite(both), Geometry(rectangle(0, 0, 3, 2)));
}

TEST(Boolean, StrictNamesTheOperand) {
  const Region bow_tie = make_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  const Region good = rectangle(0, 0, 1, 1);
  Options strict;
  strict.fill = FillRule::kStrict;
  const auto culprit_of = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.culprit().operand;
    }
    return -2;
  };
  EXPECT_EQ(culprit_of([&] { (void)intersect(good, bow_tie, strict); }), 1);
  EXPECT_EQ(culprit_of([&] { (void)subtract(bow_tie, good, strict); }), 0);
  const Geometry three[] = {good, good, bow_tie};
  EXPECT_EQ(culprit_of([&] { (void)unite(three, strict); }), 2);
}

TEST(PointLocator, ReadsRingsByTheFillRule) {
  // The ring goes round the square [1, 3] × [0, 4] twice, and crosses itself at (2, 5).
  const Geometry crossed(make_polygon(
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {3, 0}, {3, 4}, {1, 6}, {3, 6}, {1, 4}, {1, 0}}));
  const auto place = [&](const Point& point, FillRule fill) {
    Options options;
    options.fill = fill;
    return PointLocator(crossed, options).locate(point);
  };
  EXPECT_EQ(place({2, 1}, FillRule::kEvenOdd), Location::kOutside);
  EXPECT_EQ(place({2, 1}, FillRule::kNonZero), Location::kInside);
  EXPECT_EQ(place({2, 5}, FillRule::kNonZero), Location::kBoundary);
  EXPECT_EQ(place({2, 1}, FillRule::kNegative), Location::kOutside);
  EXPECT_THROW((void)place({2, 1}, FillRule::kStrict), Error);
}

TEST(PointLocator, ThinPartsMayLieInsideTheArea) {
  Geometry geometry(make_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  geometry.polylines = {{{-2, 2}, {2, 2}, {2, 6}}, {{-1, 1}, {-1, 3}}};
  geometry.points = {{1, 1}, {9, 9}};
  const PointLocator locator(geometry);
  EXPECT_EQ(locator.locate({1, 1}), Location::kInside);
  EXPECT_EQ(locator.locate({2, 2}), Location::kInside);
  EXPECT_EQ(locator.locate({2, 4}), Location::kBoundary);
  EXPECT_EQ(locator.locate({2, 5}), Location::kBoundary);
  EXPECT_EQ(locator.locate({-1, 2}), Location::kBoundary);
  EXPECT_EQ(locator.locate({9, 9}), Location::kBoundary);
  EXPECT_EQ(locator.locate({-1, 4}), Location::kOutside);
}

}  // namespace

// Tests rounding of geometries with thin parts that are small enough to check by eye.
#include <gtest/gtest.h>

#include <array>

#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "support/geometries.hpp"
#include "support/rounding_options.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

RoundOptions to_integers(RoundingSide side) { return to_decimals(0, side); }

Geometry lines(std::vector<Polyline> polylines, std::vector<Point> points = {}) {
  return {{}, std::move(polylines), std::move(points)};
}

Region triangle(Ring outer) { return Region(Polygon{std::move(outer), {}}); }

/// Expects that rounding to both sides, to doubles and to decimals, keeps its promises.
void expect_sides_of(const Geometry& exact) {
  for (const std::optional<int> decimals :
       {std::optional<int>{}, std::optional<int>{1}, std::optional<int>{0}}) {
    for (const RoundingSide side : {RoundingSide::kOutside, RoundingSide::kInside}) {
      RoundingReport report;
      const Geometry rounded = round(exact, rounding(decimals, side), report);
      SCOPED_TRACE(std::string(to_string(side)) + ' ' + to_text(rounded));
      EXPECT_EQ(resolve(rounded), rounded);
      EXPECT_EQ(report.exact, rounded == exact);
      EXPECT_LE(report.largest_move, report.bound);
      EXPECT_TRUE(side == RoundingSide::kOutside ? contains(rounded, exact)
                                                 : contains(exact, rounded));
    }
  }
}

TEST(RoundGeometry, PathsAndPointsGoToTheNearest) {
  Geometry thin;
  thin.polylines = {{point("0", "0"), point("10/3", "1/3"), point("5", "5")}};
  thin.points = {point("-1/3", "7")};
  RoundingReport report;
  const Geometry rounded = round(thin, to_decimals(1), report);
  Geometry expected;
  expected.polylines = {{point("0", "0"), point("3.3", "0.3"), point("5", "5")}};
  expected.points = {point("-0.3", "7")};
  EXPECT_EQ(rounded, expected);
  EXPECT_TRUE(report.topology_kept);
  EXPECT_FALSE(report.snapped);
  EXPECT_GT(report.largest_move, 0.0471);
  EXPECT_LT(report.largest_move, 0.0472);
  EXPECT_LE(report.largest_move, report.bound);
}

TEST(RoundGeometry, PathsThatWouldCrossAreSnapped) {
  Geometry thin;
  thin.polylines = {{point("0", "0"), point("9", "1")}, {point("0", "-3"), point("5", "0.54")}};
  RoundingReport report;
  const Geometry rounded = round(thin, to_decimals(0), report);
  EXPECT_TRUE(report.snapped);
  Geometry expected;
  expected.polylines = {{point("0", "-3"), point("5", "1")},
                        {point("0", "0"), point("5", "1")},
                        {point("5", "1"), point("9", "1")}};
  EXPECT_EQ(rounded, expected);
}

TEST(RoundGeometry, PathsStayWhereTheyEndOnAnEdge) {
  Geometry geometry;
  geometry.region = third_triangle();
  // The polyline ends in the middle of the slanted edge.
  geometry.polylines = {{point("1/6", "1/3"), point("2", "2")}};
  RoundingReport report;
  const Geometry rounded = round(resolve(geometry), to_decimals(3), report);
  EXPECT_EQ(resolve(rounded), rounded);
  EXPECT_LE(report.largest_move, report.bound);
  ASSERT_EQ(rounded.polylines.size(), 1U);
  EXPECT_EQ(rounded.polylines[0].back(), point("2", "2"));
  const Region& region = rounded.region;
  bool attached = false;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    attached |= region.point(v) == rounded.polylines[0].front();
  }
  EXPECT_TRUE(attached);
  expect_sides_of(resolve(geometry));
}

TEST(RoundGeometry, WhatIsExactStaysThin) {
  Geometry exact = lines({{point("0", "0"), point("3", "4"), point("5", "4")}}, {point("7", "7")});
  exact.region = rectangle(5, 0, 8, 4);
  exact = resolve(exact);
  for (const RoundingSide side : {RoundingSide::kOutside, RoundingSide::kInside}) {
    for (const RoundOptions& options : {to_integers(side), to_decimals(3, side)}) {
      RoundingReport report;
      EXPECT_EQ(round(exact, options, report), exact);
      EXPECT_TRUE(report.exact);
      EXPECT_TRUE(report.topology_kept);
      EXPECT_EQ(report.largest_move, 0);
    }
  }
}

TEST(RoundGeometry, AShortSegmentIsNotLost) {
  const Geometry segment = lines({{point("0", "0"), point("1/3", "1/7")}});
  RoundingReport report;
  const Geometry outside = round(segment, to_integers(RoundingSide::kOutside), report);
  EXPECT_EQ(outside, (Geometry{rectangle(0, 0, 1, 1), {}, {}}));
  EXPECT_FALSE(report.exact);
  EXPECT_FALSE(report.topology_kept);
  EXPECT_GT(report.largest_move, 1.08);  // from (1/3, 1/7) to (1, 1)
  EXPECT_LT(report.largest_move, 1.09);
  EXPECT_EQ(round(segment, to_integers(RoundingSide::kInside), report),
            lines({}, {point("0", "0")}));
  EXPECT_FALSE(report.exact);
  EXPECT_EQ(report.largest_move, 0);
  expect_sides_of(segment);
}

TEST(RoundGeometry, APointBecomesItsCell) {
  const Geometry inner = lines({}, {point("0.4", "0.4")});
  EXPECT_EQ(round(inner, to_integers(RoundingSide::kOutside)),
            (Geometry{rectangle(0, 0, 1, 1), {}, {}}));
  RoundingReport report;
  EXPECT_TRUE(round(inner, to_integers(RoundingSide::kInside), report).empty());
  EXPECT_FALSE(report.exact);
  const Geometry on_line = lines({}, {point("2", "-1/2")});
  EXPECT_EQ(round(on_line, to_integers(RoundingSide::kOutside), report),
            lines({{point("2", "-1"), point("2", "0")}}));
  EXPECT_FALSE(report.exact);
  EXPECT_GE(report.largest_move, 0.5);
  EXPECT_TRUE(round(on_line, to_integers(RoundingSide::kInside)).empty());
  expect_sides_of(inner);
  expect_sides_of(on_line);
}

TEST(RoundGeometry, SegmentsAlongAnAxisStayThin) {
  const Geometry level = lines({{point("1/3", "2"), point("7/2", "2")}});
  EXPECT_EQ(round(level, to_integers(RoundingSide::kOutside)),
            lines({{point("0", "2"), point("4", "2")}}));
  EXPECT_EQ(round(level, to_integers(RoundingSide::kInside)),
            lines({{point("1", "2"), point("3", "2")}}));
  const Geometry upright = lines({{point("-5", "1/3"), point("-5", "7/4")}});
  EXPECT_EQ(round(upright, to_integers(RoundingSide::kInside)), lines({}, {point("-5", "1")}));
  const Geometry between = lines({{point("1/3", "1/2"), point("7/2", "1/2")}});
  EXPECT_TRUE(round(between, to_integers(RoundingSide::kInside)).empty());
  for (const Geometry& exact : {level, upright, between}) expect_sides_of(exact);
}

TEST(RoundGeometry, InsideKeepsTheExactPartOfAPath) {
  const Geometry path = lines(
      {{point("0", "0"), point("2", "1"), point("3", "5"), point("7/2", "8"), point("9", "9")}});
  EXPECT_EQ(round(path, to_integers(RoundingSide::kInside)),
            lines({{point("0", "0"), point("2", "1"), point("3", "5")}}, {point("9", "9")}));
  expect_sides_of(path);
}

TEST(RoundGeometry, AreasPathsAndPointsTogether) {
  Geometry mixed =
      lines({{point("1/3", "1/3"), point("5/7", "6/7")}}, {point("9/7", "1/9"), point("4", "4")});
  mixed.region = triangle({point("0", "0"), point("1/3", "0"), point("1/3", "1/3")});
  Geometry outside{rectangle(0, 0, 2, 1), {}, {point("4", "4")}};
  RoundingReport report;
  EXPECT_EQ(round(resolve(mixed), to_integers(RoundingSide::kOutside), report), outside);
  EXPECT_LE(report.largest_move, report.bound);
  EXPECT_EQ(round(resolve(mixed), to_integers(RoundingSide::kInside)),
            lines({}, {point("4", "4")}));
  expect_sides_of(resolve(mixed));
}

TEST(RoundGeometry, CrossingsThatAreNotOfTheTarget) {
  // All ends are integers.
  expect_sides_of(resolve(lines({{point("0", "0"), point("9", "1")},
                                 {point("0", "1"), point("9", "0")},
                                 {point("0", "-3"), point("5", "4")}})));
}

TEST(RoundGeometry, ExactPathsThatARegionGrowsOver) {
  // The slanted edge moves over the end of the path, so the rest ends between the integers.
  Geometry geometry = lines({{point("4", "4"), point("9", "5")},
                             {point("3", "5"), point("3", "9")},
                             {point("5", "3"), point("9", "3")}});
  geometry.region = triangle({point("0", "0"), point("33/4", "0"), point("0", "33/4")});
  expect_sides_of(resolve(geometry));
  // The cells around these ends have no width along one axis.
  geometry.polylines = {{point("2", "25/4"), point("2", "9")},
                        {point("25/4", "2"), point("9", "2")}};
  expect_sides_of(resolve(geometry));
}

TEST(RoundGeometry, SidesOfSmallAndLargeNumbers) {
  expect_sides_of(lines({{point("0", "0"), point("1e-320", "1e-325")}}, {point("1e300", "1/3")}));
  expect_sides_of(lines({{point("-1e-400", "0"), point("1e-400", "1e-400")}}));
  EXPECT_THROW(
      (void)round(lines({}, {point("1e400", "0")}), RoundOptions{RoundingSide::kOutside, {}}),
      Error);
}

TEST(RoundGeometry, PartsMayLieInEachOther) {
  // These polylines cross each other and the region. One is a point.
  Geometry mess = lines({{point("-1", "-2/3"), point("7", "5/2"), point("-1", "3")},
                         {point("0", "5"), point("13/2", "-4")},
                         {point("1/3", "9/2")}},
                        {point("5/2", "1"), point("11/2", "1/7"), point("11/2", "1/7")});
  mess.region = triangle({point("1/3", "0"), point("19/4", "0"), point("5/3", "21/5")});
  const Geometry exact = resolve(mess);
  for (const std::optional<int> decimals : {std::optional<int>{}, std::optional<int>{0}}) {
    for (const RoundingSide side : {RoundingSide::kOutside, RoundingSide::kInside}) {
      EXPECT_EQ(round(mess, rounding(decimals, side)), round(exact, rounding(decimals, side)));
    }
    const Geometry nearest = round(mess, rounding(decimals, RoundingSide::kNearest));
    EXPECT_EQ(resolve(nearest), nearest);
  }
  expect_sides_of(exact);
}

TEST(RoundGeometry, TightPlacesGoToTheNearest) {
  Geometry no_fit = lines({{point("2", "1"), point("2", "11/3")}}, {point("1/3", "1")});
  no_fit.region = rectangle(0, 0, 6, 4);
  const Geometry area(no_fit.region);
  EXPECT_EQ(resolve(no_fit), area);
  EXPECT_EQ(resolve_with_tight_places(no_fit), no_fit);
  Geometry expected = lines({{point("2", "1"), point("2", "4")}}, {point("0", "1")});
  expected.region = no_fit.region;
  Options without;
  without.tight = false;
  Geometry mixed = no_fit;
  mixed.points.push_back(point("7", "1/3"));
  EXPECT_EQ(resolve_with_tight_places(mixed), resolve(mixed));
  for (const RoundingSide side : kRoundingSides) {
    EXPECT_EQ(round_with_tight_places(no_fit, to_integers(side)), expected);
    EXPECT_EQ(round_with_tight_places(no_fit, to_integers(side), without), area);
    EXPECT_EQ(round_with_tight_places(mixed, to_integers(side)),
              round(resolve(mixed), to_integers(side)));
  }
}

TEST(RoundGeometry, RefusesRegionsThatAreNotValid) {
  Geometry crossed = lines({}, {point("1/3", "9")});
  crossed.region = make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  for (const RoundingSide side : {RoundingSide::kOutside, RoundingSide::kInside}) {
    EXPECT_THROW((void)round(crossed, to_integers(side)), Error);
  }
}

}  // namespace

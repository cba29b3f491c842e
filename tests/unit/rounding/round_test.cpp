// Tests rounding on regions that are small enough to check by eye.
#include "minksum/round.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "minksum/boolean.hpp"
#include "minksum/minkowski_sum.hpp"
#include "rounding/hot_pixels.hpp"
#include "rounding/keep_topology.hpp"
#include "rounding/round_vertices.hpp"
#include "support/random.hpp"
#include "support/rounding_options.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

Region polygon(Ring outer, std::vector<Ring> holes = {}) {
  return Region(Polygon{std::move(outer), std::move(holes)});
}

TEST(Round, NearestDoubles) {
  RoundingReport report;
  const Region rounded = round(third_triangle(), {}, report);
  Region expected;
  expected.begin_polygon();
  expected.begin_ring();
  expected.add_vertex(0.0, 0.0);
  expected.add_vertex(1.0 / 3, 0.0);
  expected.add_vertex(0.0, 2.0 / 3);
  EXPECT_EQ(rounded, expected);
  EXPECT_FALSE(report.exact);
  EXPECT_FALSE(report.snapped);
  EXPECT_TRUE(report.topology_kept);
  EXPECT_GE(Rational(report.largest_move), Rational(2.0 / 3) < Rational(2, 3)
                                               ? Rational(2, 3) - Rational(2.0 / 3)
                                               : Rational(2.0 / 3) - Rational(2, 3));
  EXPECT_LE(report.largest_move, report.bound);
  EXPECT_LE(report.bound, 0x1p-53);
}

TEST(Round, WhatIsExactStays) {
  const Region sum = minkowski_sum(rectangle(0, 0, 2, 3), rectangle(0, 0, 1, 1));
  for (const RoundingSide side : kRoundingSides) {
    RoundingReport report;
    const Region rounded = round(sum, to_doubles(side), report);
    EXPECT_EQ(rounded, sum);
    EXPECT_TRUE(report.exact);
    EXPECT_TRUE(report.topology_kept);
    EXPECT_EQ(report.largest_move, 0);
    ASSERT_TRUE(rounded.has_origins());
    for (std::size_t v = 0; v < sum.vertex_count(); ++v) {
      EXPECT_EQ(rounded.origin(v), sum.origin(v));
    }
  }
  EXPECT_TRUE(round(Region{}).empty());
}

TEST(Round, ResultsAreCanonicalWhateverWasGiven) {
  // The ring is clockwise, with a repeated vertex and one in the middle of an edge.
  const Region scrambled = make_polygon({{4, 0}, {2, 0}, {0, 0}, {0, 4}, {0, 4}, {4, 4}});
  EXPECT_EQ(round(scrambled), rectangle(0, 0, 4, 4));
  EXPECT_EQ(round(scrambled, to_decimals(2, RoundingSide::kInside)), rectangle(0, 0, 4, 4));
}

TEST(Round, DecimalsTieToEven) {
  const Region rounded = round(
      polygon({point("1/2", "3/2"), point("21/2", "5/2"), point("-1/2", "23/2")}), to_decimals(0));
  EXPECT_EQ(rounded, make_polygon({{0, 2}, {10, 2}, {0, 12}}));
  const Region third = round(third_triangle(), to_decimals(3));
  EXPECT_EQ(third, polygon({point("0", "0"), point("0.333", "0"), point("0", "0.667")}));
}

TEST(Round, StraightenedVerticesGo) {
  EXPECT_EQ(round(polygon({point("0", "0"), point("5", "1/3"), point("9", "0"), point("9", "9"),
                           point("0", "9")}),
                  to_decimals(0)),
            rectangle(0, 0, 9, 9));
}

TEST(Round, WhatCollapsesGoes) {
  RoundingReport report;
  const Region sliver = polygon({point("0", "0"), point("9", "1/4"), point("9", "1/3")});
  EXPECT_TRUE(round(sliver, to_decimals(0), report).empty());
  EXPECT_TRUE(report.snapped);
  EXPECT_FALSE(report.topology_kept);
  const Region outside = round(sliver, to_decimals(0, RoundingSide::kOutside), report);
  EXPECT_TRUE(contains(outside, sliver));
  EXPECT_TRUE(round(sliver, to_decimals(0, RoundingSide::kInside), report).empty());
}

TEST(Round, EdgesGoByTheVerticesThatTheyPassed) {
  // The tip of the notch at (5, 1/3) is above the lower edge. If rounded, it would touch that edge.
  const Region notched =
      polygon({point("0", "0"), point("9", "0"), point("9", "9"), point("16/3", "9"),
               point("5", "1/3"), point("4", "9"), point("0", "9")});
  RoundingReport report;
  const Region rounded = round(notched, to_decimals(0), report);
  EXPECT_TRUE(report.snapped);
  EXPECT_FALSE(report.topology_kept);
  EXPECT_EQ(rounded,
            make_region({{{{0, 0}, {5, 0}, {4, 9}, {0, 9}}}, {{{5, 0}, {9, 0}, {9, 9}, {5, 9}}}}));
}

TEST(Round, RingsThatComeToTouchMayCutAPolygon) {
  // The hole ends a quarter before both walls.
  const Region ring =
      polygon({point("0", "0"), point("8", "0"), point("8", "8"), point("0", "8")},
              {{point("1/4", "4"), point("4", "3"), point("31/4", "4"), point("4", "5")}});
  RoundingReport report;
  const Region rounded = round(ring, to_decimals(0), report);
  EXPECT_FALSE(report.topology_kept);
  EXPECT_FALSE(report.snapped);
  EXPECT_EQ(rounded, make_region({{{{0, 0}, {8, 0}, {8, 4}, {4, 3}, {0, 4}}},
                                  {{{0, 4}, {4, 5}, {8, 4}, {8, 8}, {0, 8}}}}));
}

TEST(Round, OutsideAndInsideMoveTheVerticesThatMust) {
  const Region square =
      polygon({point("0", "0"), point("10/3", "0"), point("10/3", "10/3"), point("0", "10/3")});
  RoundingReport report;
  EXPECT_EQ(round(square, to_decimals(0, RoundingSide::kOutside), report), rectangle(0, 0, 4, 4));
  EXPECT_FALSE(report.snapped);
  EXPECT_LT(report.largest_move, 0.943);
  EXPECT_EQ(round(square, to_decimals(0, RoundingSide::kInside), report), rectangle(0, 0, 3, 3));
  EXPECT_LT(report.largest_move, 0.472);
}

TEST(Round, SidesOfWhatIsTooThinForOneVertex) {
  // No corner of either tip's cell is on the right sides of both its edges.
  const Region needle = polygon({point("0", "0"), point("100", "7"), point("601/6", "71/10")});
  const Region outside = round(needle, to_decimals(0, RoundingSide::kOutside));
  EXPECT_TRUE(contains(outside, needle));
  const Region inside = round(needle, to_decimals(0, RoundingSide::kInside));
  EXPECT_TRUE(contains(needle, inside));
  EXPECT_TRUE(contains(round(needle, to_doubles(RoundingSide::kOutside)), needle));
}

TEST(Round, BeyondTheDoubles) {
  const Region huge = polygon({point("0", "0"), point("1e400", "0"), point("0", "1/3")});
  try {
    (void)round(huge);
    FAIL() << "there is no such double";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
    EXPECT_STREQ(error.what(), "a coordinate is beyond the range of doubles");
    EXPECT_EQ(error.culprit().vertex, 1U);
  }
  EXPECT_EQ(round(huge, to_decimals(1)),
            polygon({point("0", "0"), point("1e400", "0"), point("0", "0.3")}));
}

TEST(Round, LargestDoubles) {
  const double largest = std::numeric_limits<double>::max();
  const Rational x(largest);
  const Region wide =
      polygon({{Rational(0), Rational(0)}, {x, Rational(0)}, {x - Rational(1, 3), x}});
  const Region rounded = round(wide);
  EXPECT_EQ(rounded.vertex_count(), 3U);
  EXPECT_TRUE(contains(wide, round(wide, to_doubles(RoundingSide::kInside))));
  EXPECT_TRUE(contains(round(wide, to_doubles(RoundingSide::kOutside)), wide));
  // No double is far enough outside for this region.
  const Region wider =
      polygon({{Rational(0), Rational(0)}, {x + Rational(1, 3), Rational(0)}, {Rational(0), x}});
  EXPECT_EQ(round(wider).exact_x(1), x);
  EXPECT_THROW((void)round(wider, to_doubles(RoundingSide::kOutside)), Error);
  EXPECT_TRUE(contains(wider, round(wider, to_doubles(RoundingSide::kInside))));
}

TEST(Round, SmallestDoubles) {
  const Rational smallest(std::numeric_limits<double>::denorm_min());
  const Rational half = smallest * Rational(1, 2);
  const Region tiny = polygon({{Rational(0), Rational(0)},
                               {smallest * 9 + half, Rational(0)},
                               {Rational(0), smallest * 5}});
  RoundingReport report;
  const Region rounded = round(tiny, {}, report);
  EXPECT_EQ(rounded.vertex_count(), 3U);
  EXPECT_EQ(rounded.exact_x(1), smallest * 10);
  EXPECT_GE(Rational(report.largest_move), half);
  EXPECT_TRUE(contains(round(tiny, to_doubles(RoundingSide::kOutside)), tiny));
  EXPECT_TRUE(contains(tiny, round(tiny, to_doubles(RoundingSide::kInside))));
  const Region nothing = scaled(tiny, Rational(1, 100));
  EXPECT_TRUE(round(nothing, {}, report).empty());
  EXPECT_TRUE(contains(round(nothing, to_doubles(RoundingSide::kOutside)), nothing));
}

TEST(Round, AThousandDigits) {
  RoundingReport report;
  const Region rounded = round(third_triangle(), to_decimals(1000), report);
  const Rational third = Rational(1, 3);
  const Rational off = third - rounded.exact_x(1);
  EXPECT_EQ(off * *Rational::parse("1e1000"), third);
  EXPECT_GT(report.largest_move, 0);
  for (const RoundingSide side : {RoundingSide::kOutside, RoundingSide::kInside}) {
    const Region sided = round(third_triangle(), to_decimals(1000, side));
    EXPECT_EQ(contains(sided, third_triangle()), side == RoundingSide::kOutside);
    EXPECT_EQ(contains(third_triangle(), sided), side == RoundingSide::kInside);
  }
}

TEST(Round, RefusesWhatIsNoRegion) {
  EXPECT_THROW((void)round(make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}})), Error);
  EXPECT_THROW((void)round(third_triangle(), to_decimals(-1)), Error);
  EXPECT_THROW((void)round(third_triangle(), to_decimals(5000)), Error);
}

TEST(Round, StopsWhenAsked) {
  Options options;
  options.cancel.emplace();
  options.cancel->cancel();
  try {
    (void)round(third_triangle(), {}, options);
    FAIL() << "cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

TEST(Round, SidesHaveNames) {
  EXPECT_STREQ(to_string(RoundingSide::kNearest), "nearest");
  EXPECT_STREQ(to_string(RoundingSide::kOutside), "outside");
  EXPECT_STREQ(to_string(RoundingSide::kInside), "inside");
}

// -- The parts of rounding ----------------------------------------------------------------------

// Tells whether no other double is nearer to a number, and whether a tie has gone to even.
bool is_nearest(double value, const Rational& exact) {
  const auto distance = [&](double to) {
    const Rational difference = Rational(to) - exact;
    return difference.sign() < 0 ? -difference : difference;
  };
  return std::ranges::all_of(std::array{-HUGE_VAL, HUGE_VAL}, [&](double way) {
    const double next = std::nextafter(value, way);
    const bool is_even = (std::bit_cast<std::uint64_t>(value) & 1) == 0;
    return distance(value) < distance(next) || (is_even && distance(value) == distance(next));
  });
}

BigInteger random_odd(Random& random, int bits) {
  BigInteger result = 1;
  for (int i = 1; i < bits; ++i) result = (result << 1) + (i + 1 == bits ? 1 : random.below(2));
  return random.one_in(2) ? -result : result;
}

TEST(RoundVertices, TellsTheNearestDoublesAndHowFarTheyAre) {
  Random random(11);
  const Options options;
  Cancellation cancellation(options, Stage::kRounding);
  for (int bits = 1; bits <= 140; ++bits) {
    Region region;
    region.begin_polygon();
    region.begin_ring();
    for (const int tens : {0, 1, 15, 18, 19, 20, 40}) {
      for (const int twos : {-1100, -200, -60, -1, 0, 1, 30}) {
        const BigInteger divisor = abs(random_odd(random, 1 + random.below(40)));
        region.add_vertex(RationalAccess::make(random_odd(random, bits), 1, twos, -tens),
                          RationalAccess::make(random_odd(random, bits), divisor, twos, -tens));
      }
    }
    const RoundedVertices vertices = round_vertices(region, {}, cancellation);
    ASSERT_EQ(vertices.size(), 49U);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const auto check = [&](const Rational& exact, const RoundedCoordinate& place, double off) {
        EXPECT_TRUE(is_nearest(place.value, exact)) << exact;
        const Rational difference = exact - Rational(place.value);
        EXPECT_EQ(off == 0, difference.sign() == 0) << exact;
        const bool is_least = std::abs(off) == std::numeric_limits<double>::denorm_min();
        EXPECT_TRUE(is_least || is_nearest(off, difference)) << exact;
      };
      check(region.exact_x(v), vertices[v].x, vertices[v].off_x);
      check(region.exact_y(v), vertices[v].y, vertices[v].off_y);
    }
  }
}

TEST(KeepTopology, Judges) {
  Cancellation never;
  const Region exact = make_polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{{1, 4}, {4, 3}, {7, 4}}});
  EXPECT_EQ(check_topology(exact, exact, never).outcome, TopologyVerdict::kKept);
  const auto moved = [](const Outline& hole) {
    return make_polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {hole});
  };
  EXPECT_EQ(check_topology(exact, moved({{0, 4}, {4, 3}, {7, 4}}), never).outcome,
            TopologyVerdict::kKept);
  EXPECT_EQ(check_topology(exact, moved({{0, 4}, {4, 3}, {8, 4}}), never).outcome,
            TopologyVerdict::kCut);
  EXPECT_EQ(check_topology(exact, moved({{1, 4}, {4, 5}, {7, 4}}), never).outcome,
            TopologyVerdict::kInvalid);
  EXPECT_EQ(check_topology(exact, moved({{1, 4}, {4, 4}, {7, 4}}), never).outcome,
            TopologyVerdict::kInvalid);
  EXPECT_EQ(check_topology(exact, moved({{-1, 4}, {4, 3}, {7, 4}}), never).outcome,
            TopologyVerdict::kInvalid);
  EXPECT_EQ(check_topology(exact, moved({{11, 4}, {14, 3}, {17, 4}}), never).outcome,
            TopologyVerdict::kInvalid);
}

TEST(KeepTopology, ThreeRingsAtOnePointCutNothing) {
  Cancellation never;
  const Region exact =
      make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                   {{{4, 4}, {5, 4}, {4, 5}}, {{4, 4}, {3, 4}, {4, 3}}, {{4, 4}, {3, 5}, {3, 6}}});
  EXPECT_EQ(check_topology(exact, exact, never).outcome, TopologyVerdict::kKept);
}

TEST(KeepTopology, AChainOfHolesCutsAtItsEnd) {
  Cancellation never;
  const auto with = [](std::int64_t last) {
    return make_polygon(
        {{0, 0}, {9, 0}, {9, 9}, {0, 9}},
        {{{0, 4}, {3, 3}, {3, 5}}, {{3, 4}, {6, 3}, {6, 5}}, {{6, 4}, {last, 3}, {8, 5}}});
  };
  EXPECT_EQ(check_topology(with(8), with(8), never).outcome, TopologyVerdict::kKept);
  EXPECT_EQ(check_topology(with(8), with(9), never).outcome, TopologyVerdict::kCut);
}

TEST(HotPixels, AreHalfOpen) {
  const auto meets = [](const char* ax, const char* ay, const char* bx, const char* by) {
    const Point a = point(ax, ay);
    const Point b = point(bx, by);
    return meets_pixel(snap_point(a.x, a.y), snap_point(b.x, b.y), {0, 0});
  };
  EXPECT_TRUE(meets("-1", "0", "1", "0"));
  EXPECT_TRUE(meets("-1", "-1/2", "1", "-1/2"));  // along the lower side
  EXPECT_FALSE(meets("-1", "1/2", "1", "1/2"));   // along the upper side
  EXPECT_TRUE(meets("-1/2", "-1", "-1/2", "1"));
  EXPECT_FALSE(meets("1/2", "-1", "1/2", "1"));
  EXPECT_TRUE(meets("-1", "0", "0", "-1"));  // through the lower left corner
  EXPECT_FALSE(meets("0", "1", "1", "0"));   // through the upper right one
  EXPECT_FALSE(meets("-1", "0", "0", "1"));  // upper left
  EXPECT_FALSE(meets("0", "-1", "1", "0"));  // lower right
  EXPECT_TRUE(meets("-1", "0", "-1/2", "0"));
  EXPECT_FALSE(meets("1", "0", "1/2", "0"));
  EXPECT_TRUE(meets("-1e30", "-1e30", "1e30", "999999999999999999999999999999.99"));
  EXPECT_FALSE(meets("-1e30", "-1e30", "1e30", "1000000000000000000000000000002.01"));
}

TEST(HotPixels, AreFoundLikeByTryingAll) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    // The grids range from one pixel for all points to more pixels than a double can count.
    const int scale = random.between(0, 70);
    Rational size(1, 7);
    for (int i = 0; i < scale; ++i) size = size * 2;
    std::vector<SnapPoint> points;
    for (int i = random.between(2, 60); i > 0; --i) {
      const Rational x = size * random.between(-50, 50);
      // Some points are close to a diagonal.
      const Rational y = random.one_in(3) ? x + Rational(random.between(-9, 9), 7)
                                          : size * random.between(-50, 50);
      points.push_back(snap_point(x, y));
    }
    Cancellation never;
    HotPixels pixels(points, never);
    std::vector<PixelId> met;
    for (std::size_t a = 0; a + 1 < points.size(); ++a) {
      const std::size_t b = a + 1;
      pixels.list_met(points[a], a, points[b], b, never, met);
      ASSERT_FALSE(met.empty());
      EXPECT_EQ(met.front(), pixels.pixel_of(a));
      EXPECT_EQ(met.back(), pixels.pixel_of(b));
      for (std::size_t p = 0; p < points.size(); ++p) {
        const PixelId pixel = pixels.pixel_of(p);
        EXPECT_EQ(std::count(met.begin(), met.end(), pixel),
                  meets_pixel(points[a], points[b], pixels.centre(pixel)) ? 1 : 0)
            << "seed " << seed;
      }
    }
  }
}

}  // namespace

// Tests sums of small operands by a walk along the outer boundary.
#include "sum/small/small_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "minksum/prepared_region.hpp"
#include "minksum/testing.hpp"
#include "minksum/transform.hpp"
#include "sum/small/sides.hpp"
#include "support/polygon_kinds.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "unit/sum/small/square_with_holes.hpp"

namespace minksum {
namespace {

using test::make_polygon;
using test::rectangle;
using test::with_holes;

/// Computes a small sum; returns false if the stages have to compute it.
bool sum(const Region& p, const Region& q, Region& result) {
  SmallOperand small_p;
  SmallOperand small_q;
  SmallScratch scratch;
  EXPECT_TRUE(read_small(p, small_p));
  EXPECT_TRUE(read_small(q, small_q));
  return sum_small(small_p, small_q, scratch, result);
}

TEST(SureLanes, HaveTheExactSign) {
  const auto sign = [](auto value) { return (value > 0) - (value < 0); };
  const double far = 0x1p49;
  const std::array<std::pair<Vec<double>, Vec<double>>, 8> pairs{{
      {{far - 1, far - 3}, {far - 1, far - 3}},
      {{far - 1, far - 3}, {1 - far, 3 - far}},
      {{far - 1, far - 3}, {far - 1, far - 2}},
      {{far - 1, far - 3}, {1 - far, 2 - far}},
      {{5, 0}, {far, 0}},
      {{far - 1, far - 2}, {far - 2, far - 3}},  // -1, and doubles say 0
      {{far - 2, far - 3}, {far - 1, far - 2}},
      {{0x1p30 + 1, 0x1p30 + 3}, {3 * (0x1p30 + 1), 3 * (0x1p30 + 3)}},
  }};
  using Lanes = SureLanes<std::uint64_t>;
  for (const auto& [a, b] : pairs) {
    const auto wide = [](const Vec<double>& v) {
      return Vec<Int128>{static_cast<Int128>(v.x), static_cast<Int128>(v.y)};
    };
    const int exact = sign(cross(wide(a), wide(b)));
    EXPECT_EQ(sign(Lanes{}.side(Lanes::of_whole(a), Lanes::of_whole(b))), exact) << a.x;
    bool unsure = false;
    const double rounded = RoundedLanes{unsure}.side(a, b);
    EXPECT_TRUE(unsure || sign(rounded) == exact) << a.x << " " << b.x;
  }
}

TEST(SureLanes, HaveTheExactSignOfRoundedVectors) {
  test::Random random(1);
  const auto number = [&](int bits) {
    if (bits == 0) return Int128{0};
    const auto high = static_cast<Int128>(random.next()) << 64U;
    return (high + static_cast<Int128>(random.next() >> 1U)) >> (127 - bits);
  };
  const auto sure = [](const Vec<Int128>& v) {
    return SureVec<Int128>{{static_cast<double>(v.x), static_cast<double>(v.y)}, v};
  };
  std::array<int, 3> count{};
  for (int k = 0; k < 100'000; ++k) {
    const int bits = random.between(50, 125);
    const Vec<Int128> a{number(bits - 2), number(bits - 2)};
    // The other vector is nearly a multiple.
    const Int128 times = random.between(-3, 3);
    const int few = random.one_in(3) ? 0 : random.between(0, bits - 2);
    const Vec<Int128> b{times * a.x + number(few), times * a.y + number(few)};
    const Sign exact = sign_of(product<WideInt<4>>(a.x, b.y) - product<WideInt<4>>(a.y, b.x));
    ++count[static_cast<std::size_t>(exact + 1)];
    const SureLanes<Int128> lanes{{0x1p-48 * std::ldexp(1, bits)}};
    EXPECT_EQ(sign_of(lanes.turn(sure(a), sure(b))), exact);
    EXPECT_EQ(sign_of(lanes.side(sure(a), sure(b))), exact);
  }
  for (const int of_sign : count) EXPECT_GT(of_sign, 5'000);
}

TEST(SmallSum, IsMadeWhereThereIsNoHole) {
  const Region l = make_polygon({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 5}, {0, 5}});
  Region result;
  ASSERT_TRUE(sum(l, l, result));
  EXPECT_EQ(result,
            make_polygon({{0, 0}, {8, 0}, {8, 2}, {5, 2}, {5, 6}, {2, 6}, {2, 10}, {0, 10}}));
  EXPECT_TRUE(result.has_origins());
  ASSERT_TRUE(sum(rectangle(0, 0, 2, 1), test::round_polygon(8, 10), result));
  EXPECT_EQ(result.vertex_count(), 12U);  // no edges are parallel
}

TEST(SmallSum, HasHoles) {
  const Region c = make_polygon({{0, 0},
                                 {9, 0},
                                 {9, 3},
                                 {7, 3},
                                 {7, 2},
                                 {2, 2},
                                 {2, 7},
                                 {7, 7},
                                 {7, 5},
                                 {9, 5},
                                 {9, 9},
                                 {0, 9}});
  Region result;
  ASSERT_TRUE(sum(c, rectangle(0, 0, 2, 2), result));
  EXPECT_EQ(result,
            make_polygon({{0, 0}, {11, 0}, {11, 11}, {0, 11}}, {{{4, 4}, {4, 7}, {7, 7}, {7, 4}}}));
  EXPECT_EQ(result.origin(4).edge_operand, Operand::kFirst);
  EXPECT_EQ(result.origin(4).edge, 5U);
  ASSERT_TRUE(sum(c, rectangle(0, 0, 2, 1), result));  // leaves the opening open
  EXPECT_EQ(result.hole_count(), 0U);
}

TEST(SmallSum, HasHolesWhereNumbersAreLong) {
  // The operands' own numbers have some 120 and 61 bits, and some 180 on one grid.
  const Rational one_and_little(1'000'000'000'000'000'001, 1'000'000'000'000'000'000);
  const Affine twice = Affine::scaling(one_and_little * one_and_little);
  const Affine binary =
      Affine::scaling(Rational((std::int64_t{1} << 61) + 1, std::int64_t{1} << 61));
  const Region triangle = make_polygon({{0, 0}, {2, 1}, {1, 3}});
  const Region p =
      transform(with_holes({{{1, 2}, {2, 6}, {4, 4}}, {{5, 5}, {8, 6}, {6, 8}}}), twice);
  SumSettings by_stages;
  by_stages.small = false;
  for (const int part : {1, 8, 1000}) {
    const Region q = transform(transform(triangle, Affine::scaling(Rational(1, part))), binary);
    const DetailedSum detailed = detailed_sum(p, q);
    EXPECT_TRUE(detailed.statistics.small) << part;
    EXPECT_EQ(detailed.sum.region.hole_count(), part == 1 ? 0U : 2U);
    EXPECT_EQ(detailed.sum.region, minkowski_sum(p, q, by_stages));
  }
}

TEST(SmallSum, HasHolesInOrder) {
  // Most corners of the sum's holes are no integers.
  const test::Outline left{{1, 2}, {2, 6}, {4, 4}};
  const test::Outline right{{1, 1}, {4, 2}, {8, 1}};
  const Region p = with_holes({right, left, {{5, 5}, {8, 6}, {6, 8}}});
  const Region q =
      transform(make_polygon({{0, 0}, {2, 1}, {1, 3}}), Affine::scaling(Rational(1, 8)));
  const DetailedSum detailed = detailed_sum(p, q);
  EXPECT_TRUE(detailed.statistics.small);
  EXPECT_EQ(detailed.sum.region.hole_count(), 3U);
  SumSettings settings;
  settings.small = false;
  EXPECT_EQ(detailed.sum.region, minkowski_sum(p, q, settings));
}

TEST(SmallSum, KeepsHolesIntoWhichTheOtherOperandFits) {
  const Region p = with_holes({{{1, 1}, {4, 1}, {4, 3}, {1, 3}}, {{5, 5}, {6, 5}, {6, 6}}});
  Region result;
  ASSERT_TRUE(sum(p, rectangle(0, 0, 3, 1), result));  // as wide as the hole
  EXPECT_EQ(result, rectangle(0, 0, 12, 10));
  EXPECT_EQ(result.origin(1).edge_operand, Operand::kFirst);
  ASSERT_TRUE(sum(rectangle(0, 0, 1, 2), p, result));  // as high
  EXPECT_EQ(result, rectangle(0, 0, 10, 11));
  ASSERT_TRUE(sum(p, rectangle(0, 0, 2, 1), result));  // fits
  EXPECT_EQ(result,
            make_polygon({{0, 0}, {11, 0}, {11, 10}, {0, 10}}, {{{3, 2}, {3, 3}, {4, 3}, {4, 2}}}));
  Region exchanged;
  ASSERT_TRUE(sum(rectangle(0, 0, 2, 1), p, exchanged));
  EXPECT_EQ(exchanged, result);
  ASSERT_TRUE(sum(p, p, result));
  EXPECT_EQ(result, rectangle(0, 0, 18, 18));
  // The frame is turned and on another grid.
  const Region turned = transform(p, Affine::quarter_turns(1));
  SmallOperand small;
  SmallOperand small_turned;
  ASSERT_TRUE(read_small(p, small));
  turn(small, 1, small_turned);
  SmallOperand bar;
  ASSERT_TRUE(read_small(transform(rectangle(0, 0, 5, 12), Affine::scaling(Rational(1, 5))), bar));
  SmallScratch scratch;
  ASSERT_TRUE(sum_small(small_turned, bar, scratch, result));  // 1 and 12/5 fit into 2 and 3
  EXPECT_EQ(result.hole_count(), 1U);
  ASSERT_TRUE(sum_small(small, bar, scratch, result));  // but not into 3 and 2
  EXPECT_EQ(result, transform(rectangle(0, 0, 50, 57), Affine::scaling(Rational(1, 5))));
}

TEST(SmallSum, TakesHolesThatTouch) {
  const Region p = with_holes({{{0, 3}, {3, 2}, {3, 3}}, {{3, 3}, {4, 3}, {4, 4}}});
  SmallOperand operand;
  ASSERT_FALSE(read_small(p, operand));  // before it is validated
  const Region q = rectangle(0, 0, 4, 4);
  EXPECT_TRUE(detailed_sum(p, q).statistics.small);
  EXPECT_EQ(minkowski_sum(p, q), rectangle(0, 0, 13, 13));
  SumSettings settings;
  Workspace workspace;
  Region result;
  EXPECT_TRUE(
      minkowski_sum(PreparedRegion(q), PreparedRegion(p), settings, workspace, result).ok());
  EXPECT_EQ(result, rectangle(0, 0, 13, 13));
  // This square fits into one of the holes.
  const DetailedSum open = detailed_sum(p, transform(q, Affine::scaling(Rational(1, 8))));
  EXPECT_TRUE(open.statistics.small);
  EXPECT_EQ(open.sum.region.hole_count(), 1U);
  SumSettings by_stages;
  by_stages.small = false;
  EXPECT_EQ(open.sum.region,
            detailed_sum(p, transform(q, Affine::scaling(Rational(1, 8))), by_stages).sum.region);
  // A hole that crosses the ring is a fault, as before.
  const Outcome outcome =
      minkowski_sum(make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{8, 3}, {11, 3}, {8, 5}}}), q,
                    settings, workspace, result);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->code(), ErrorCode::kBadInput);
}

TEST(SmallSum, IsMadeOfManySegments) {
  test::Outline waves;
  for (int k = 0; k < 60; ++k) {
    const double radius = k % 2 == 0 ? 5000 : 4950 - 3 * k;
    const double angle = k * std::numbers::pi / 30;
    waves.push_back(
        {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  const Region p = make_polygon(waves);
  const Region q = transform(p, Affine::quarter_turns(1));
  Region result;
  ASSERT_TRUE(sum(p, q, result));
  SumSettings by_stages;
  by_stages.small = false;
  const DetailedSum expected = detailed_sum(p, q, by_stages);
  EXPECT_EQ(result, expected.sum.region);
  EXPECT_GT(expected.statistics.convolution_segments, 300U);
  const Statistics small = detailed_sum(p, q).statistics;
  EXPECT_TRUE(small.small);
  EXPECT_EQ(small.convolution_segments, expected.statistics.convolution_segments);
}

/// Returns a ring of so many vertices around the origin, with waves.
Region waves(int vertices, double radius) {
  test::Outline outline;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices;
    const double r = radius * (1 + 0.2 * std::sin(7 * angle) + 0.01 * (k % 3));
    outline.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return make_polygon(outline);
}

/// Expects a small sum, equal to that by the stages, of which the cover hides segments.
void expect_cover(const Region& p, const Region& q) {
  const DetailedSum detailed = detailed_sum(p, q);
  EXPECT_TRUE(detailed.statistics.small);
  EXPECT_LT(detailed.statistics.segments_kept, detailed.statistics.convolution_segments / 2);
  SumSettings by_stages;
  by_stages.small = false;
  const DetailedSum expected = detailed_sum(p, q, by_stages);
  EXPECT_EQ(detailed.sum.region, expected.sum.region);
}

TEST(SmallSum, LeavesOutWhatTheCoverHides) {
  const Region p = waves(900, 1e6);
  const Region q = waves(50, 3e5);
  expect_cover(p, q);
  expect_cover(q, p);
  // Doubles round the products, and then the coordinates.
  expect_cover(waves(900, 1e9), waves(50, 3e8));
  const Affine far = Affine::scaling(Rational(std::int64_t{1} << 40) + Rational(1));
  expect_cover(transform(p, far), transform(q, far));
}

TEST(SmallSum, LeavesOutWhatTheCoverHidesAroundHoles) {
  // The other operand fits into one of the holes.
  Region p = waves(900, 1e6);
  for (const auto& [at, size] : {std::pair{-300'000, 250'000}, std::pair{300'000, 50'000}}) {
    p.begin_ring();
    p.add_vertex(at, size);
    p.add_vertex(at - size, 0);
    p.add_vertex(at, -size);
    p.add_vertex(at + size, 0);
  }
  const Region q = waves(50, 1e5);
  const DetailedSum detailed = detailed_sum(p, q);
  EXPECT_EQ(detailed.sum.region.hole_count(), 1U);
  expect_cover(p, q);
}

TEST(SmallSum, LooksAtPartsWhereWholeSegmentsMeetTooOften) {
  // Most of a long spike, moved by a vertex of a small shape, lies inside the sum. With a triangle
  // of this size, each spike's segments meet those of the next ones.
  const auto spikes = [](int count, double width) {
    test::Outline outline;
    for (int k = 0; k < count; ++k) {
      const double radius = width * (k % 2 == 0 ? 1 : 0.6 + 0.01 * (k % 7));
      const double angle = 2 * std::numbers::pi * k / count;
      outline.push_back(
          {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
    }
    return make_polygon(outline);
  };
  SumSettings by_stages;
  by_stages.small = false;
  for (const double width : {1e5, 1e9, 1e17}) {
    const auto size = static_cast<std::int64_t>(width / 5);
    const Region triangle = make_polygon({{0, 0}, {3 * size, size}, {size, 2 * size}});
    const DetailedSum detailed = detailed_sum(spikes(200, width), triangle);
    EXPECT_TRUE(detailed.statistics.small) << width;
    EXPECT_EQ(detailed.sum.region,
              detailed_sum(spikes(200, width), triangle, by_stages).sum.region);
  }
}

TEST(SmallSum, IsMadeOfLongConvexRings) {
  const Region p = test::round_polygon(10'000, 1'000'000'000);
  const Region q = test::round_polygon(60'000, 2'000'000'000);
  const DetailedSum detailed = detailed_sum(p, q);
  EXPECT_TRUE(detailed.statistics.small);
  SumSettings by_stages;
  by_stages.small = false;
  EXPECT_EQ(detailed.sum.region, minkowski_sum(p, q, by_stages));
}

TEST(SmallSum, ListsEqualSegmentsOfTwoEqualOperandsOnce) {
  SumSettings by_stages;
  by_stages.small = false;
  // No two edges of these rings are parallel. Each convex vertex has two segments without a copy:
  // of the edges that end and start there.
  for (const double radius : {1e5, 1e9, 1e17}) {
    const Region p = waves(31, radius);
    const Region moved = transform(p, Affine::translation(Rational(1, 2), 7));
    const DetailedSum expected = detailed_sum(p, moved, by_stages);
    const DetailedSum detailed = detailed_sum(p, moved);
    EXPECT_TRUE(detailed.statistics.small);
    EXPECT_EQ(detailed.sum.region, expected.sum.region);
    const std::uint64_t listed = detailed.statistics.convolution_segments;
    EXPECT_EQ(listed, expected.statistics.convolution_segments);
    SmallOperand small;
    ASSERT_TRUE(read_small(p, small));
    std::uint64_t convex = 0;
    for (std::size_t i = 0; i < small.size; ++i) {
      if (small.in()[i].x != 0 || small.in()[i].y != 0) ++convex;
    }
    EXPECT_EQ(2 * detailed.statistics.segments_kept, listed + 2 * convex);
  }
}

TEST(SmallSum, TakesOperandsWhoseOwnNumbersAreLong) {
  const Rational by(1'000'000'000'000'000'003, 1'000'000'000'000'000'000);
  const Rational step(1, std::int64_t{1} << 60);
  const auto made_long = [&](const Region& region) {
    return transform(region, Affine{by * by, 0, 0, by * by, Rational(-7) + step, step});
  };
  const Region rough = with_holes({{{1, 2}, {2, 6}, {4, 4}}, {{5, 5}, {8, 6}, {6, 8}}});
  const Region triangle = make_polygon({{0, 0}, {2, 1}, {1, 3}});
  const Region little = transform(triangle, Affine::scaling(by * Rational(7, 10'000)));
  const Region moved = transform(triangle, Affine::translation(by, step));
  SumSettings by_stages;
  by_stages.small = false;
  const auto expect_equal = [&](const Region& p, const Region& q, bool small) {
    const DetailedSum detailed = detailed_sum(p, q);
    EXPECT_EQ(detailed.statistics.small, small && SmallOperand::kMayBeLong);
    EXPECT_EQ(detailed.sum.region, minkowski_sum(p, q, by_stages));
    EXPECT_EQ(minkowski_sum(PreparedRegion(p), q), detailed.sum.region);
  };
  expect_equal(made_long(rough), moved, true);
  expect_equal(little, made_long(rough), true);
  expect_equal(made_long(rough), made_long(triangle), true);
  expect_equal(made_long(triangle), little, true);  // both are convex
  expect_equal(made_long(waves(31, 1e5)), made_long(waves(31, 1e5)), true);
  expect_equal(made_long(rough), triangle, false);  // whose step is over 2^125 times as long
}

TEST(SmallSum, IsLeftToTheStagesWhereMuchLiesOnFewLines) {
  const Region comb = test::comb(12, 1, 15);
  Region result;
  EXPECT_FALSE(sum(comb, comb, result));
}

TEST(SmallSum, TakesUnlikeGrids) {
  Region fine;
  fine.begin_polygon();
  fine.begin_ring();
  fine.add_vertex(Decimal{5, -1}, Decimal{0, 0});
  fine.add_vertex(Decimal{15, -1}, Decimal{0, 0});
  fine.add_vertex(Decimal{1, 0}, Decimal{25, -2});
  Region result;
  ASSERT_TRUE(sum(fine, rectangle(0, 0, 1, 1), result));
  EXPECT_EQ(test::to_text(result),
            "MULTIPOLYGON (((1/2 0, 5/2 0, 5/2 1, 2 5/4, 1 5/4, 1/2 1, 1/2 0)))");
}

TEST(SmallSum, IsNotMadeWhereLimitsAreLow) {
  EXPECT_TRUE(allow_small({}));
  Limits low;
  low.max_segments = 100'000;
  EXPECT_FALSE(allow_small(low));
}

}  // namespace
}  // namespace minksum

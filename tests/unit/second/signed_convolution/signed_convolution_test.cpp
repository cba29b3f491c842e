#include "second/signed_convolution/signed_convolution.hpp"

#include <gtest/gtest.h>

#include "minksum/measure.hpp"
#include "minksum/testing.hpp"
#include "reference/brute_force.hpp"
#include "reference/membership.hpp"
#include "reference/validity.hpp"
#include "support/data.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"

namespace minksum {
namespace {

Region signed_sum_of(const Region& p, const Region& q, SumSettings options = {}) {
  options.check = true;
  Statistics statistics;
  Region result;
  signed_convolution_sum(p, q, options, statistics, result);
  return result;
}

Region sum_of(const char* p, const char* q) {
  return signed_sum_of(test::parse_wkt(p), test::parse_wkt(q));
}

constexpr const char* kSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
constexpr const char* kFrame = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 7 2, 7 7, 2 7, 2 2))";

TEST(SignedConvolution, EmptyOperandsGiveAnEmptySum) {
  const Region square = test::parse_wkt(kSquare);
  EXPECT_TRUE(signed_sum_of(Region{}, square).empty());
  EXPECT_TRUE(signed_sum_of(square, Region{}).empty());
}

TEST(SignedConvolution, Squares) {
  EXPECT_EQ(sum_of(kSquare, "POLYGON ((0.5 0, 1.5 0, 1.5 1, 0.5 1, 0.5 0))"),
            test::parse_wkt("POLYGON ((0.5 0, 5.5 0, 5.5 5, 0.5 5, 0.5 0))"));
  EXPECT_EQ(sum_of(kSquare, kSquare), test::parse_wkt("POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0))"));
}

TEST(SignedConvolution, CrossingsAreExact) {
  // The dent of the second operand, moved along the first, ends where two edges cross.
  const Region sum =
      sum_of("POLYGON ((0 0, 1 0, 0 1, 0 0))", "POLYGON ((0 0, 7 0, 7 5, 3 1, 0 5, 0 0))");
  EXPECT_EQ(
      sum, reference::brute_force_sum(test::parse_wkt("POLYGON ((0 0, 1 0, 0 1, 0 0))"),
                                      test::parse_wkt("POLYGON ((0 0, 7 0, 7 5, 3 1, 0 5, 0 0))")));
}

TEST(SignedConvolution, AFrameKeepsAHoleOnlyWithPlay) {
  const Region with_play = sum_of(kFrame, kSquare);  // a square of 4 in a hole of 5
  EXPECT_EQ(with_play, test::parse_wkt("POLYGON ((0 0, 13 0, 13 13, 0 13, 0 0), "
                                       "(6 6, 6 7, 7 7, 7 6, 6 6))"));
  const char* whole = "POLYGON ((0 0, 14 0, 14 13, 0 13, 0 0))";
  EXPECT_EQ(sum_of(kFrame, "POLYGON ((0 0, 5 0, 5 4, 0 4, 0 0))"), test::parse_wkt(whole));
  EXPECT_EQ(sum_of(kFrame, "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))"),
            test::parse_wkt("POLYGON ((0 0, 14 0, 14 14, 0 14, 0 0))"));
}

TEST(SignedConvolution, ADiamondFitsItsHoleWithoutPlay) {
  // The square is narrower and lower than the hole's box but has no play; only the winding tells.
  EXPECT_EQ(sum_of("POLYGON ((0 0, 12 0, 12 12, 0 12, 0 0), (6 2, 10 6, 6 10, 2 6, 6 2))",
                   "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))")
                .hole_count(),
            0U);
  EXPECT_EQ(sum_of("POLYGON ((0 0, 12 0, 12 12, 0 12, 0 0), (6 2, 10 6, 6 10, 2 6, 6 2))",
                   "POLYGON ((0 0, 3 0, 3 4, 0 4, 0 0))")
                .hole_count(),
            1U);
}

TEST(SignedConvolution, PartsApartStayApart) {
  const char* two = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((9 0, 10 0, 10 1, 9 1, 9 0)))";
  const Region sum = sum_of(two, "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT_EQ(sum.polygon_count(), 2U);
  EXPECT_EQ(sum_of(two, two).polygon_count(), 3U);
}

TEST(SignedConvolution, PartsMeetingAtAPointAreTwoPolygons) {
  const Region sum =
      sum_of("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((3 3, 4 3, 4 4, 3 4, 3 3)))",
             "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT_EQ(sum, test::parse_wkt("MULTIPOLYGON (((0 0, 3 0, 3 3, 0 3, 0 0)), "
                                 "((3 3, 6 3, 6 6, 3 6, 3 3)))"));
}

TEST(SignedConvolution, AnIslandInAHoleIsAPolygon) {
  const char* ring_and_island =
      "MULTIPOLYGON (((0 0, 30 0, 30 30, 0 30, 0 0), (3 3, 27 3, 27 27, 3 27, 3 3)),"
      " ((14 14, 16 14, 16 16, 14 16, 14 14)),"
      " ((5 5, 12 5, 12 12, 5 12, 5 5), (6 6, 11 6, 11 11, 6 11, 6 6)))";
  const Region sum = sum_of(ring_and_island, "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  EXPECT_EQ(sum.polygon_count(), 3U);
  EXPECT_EQ(sum.hole_count(), 2U);
  EXPECT_EQ(reference::canonical_fault(sum), "");
}

TEST(SignedConvolution, ConvexPairsHaveTheMixedArea) {
  // area(P + Q) = area(P) + area(Q) + (area(P + Q) - area(P) - area(Q)). Scaling Q by 2 doubles the
  // last part, and makes area(Q) four times as large.
  for (int i = 0; i < 100; ++i) {
    test::Random random(static_cast<std::uint64_t>(i));
    const Region p = test::random_convex(random, 9, 40);
    const Region q = test::random_convex(random, 9, 40);
    const Rational mixed = area(signed_sum_of(p, q)) - area(p) - area(q);
    const Region twice = signed_sum_of(q, q);
    EXPECT_EQ(area(twice), Rational(4) * area(q)) << i;
    EXPECT_EQ(area(signed_sum_of(p, twice)), area(p) + Rational(4) * area(q) + Rational(2) * mixed)
        << i;
  }
}

TEST(SignedConvolution, IsCommutativeAndCanonical) {
  for (int i = 0; i < 400; ++i) {
    test::Random random(static_cast<std::uint64_t>(i));
    const test::Pair pair = test::random_pair(random);
    const Region sum = signed_sum_of(pair.p, pair.q);
    EXPECT_EQ(reference::canonical_fault(sum), "") << i << ' ' << pair.kind;
    EXPECT_EQ(sum, signed_sum_of(pair.q, pair.p)) << i << ' ' << pair.kind;
  }
}

TEST(SignedConvolution, IsWhatTheDefinitionSays) {
  for (int i = 0; i < 1000; ++i) {
    test::Random random(static_cast<std::uint64_t>(7000 + i));
    const test::Pair pair = test::random_pair(random);
    EXPECT_EQ(signed_sum_of(pair.p, pair.q), reference::brute_force_sum(pair.p, pair.q))
        << i << ' ' << pair.kind;
  }
}

TEST(SignedConvolution, HasJustThePointsThatTheOperandsMake) {
  for (int i = 0; i < 40; ++i) {
    test::Random random(static_cast<std::uint64_t>(500 + i));
    const test::Pair pair = test::random_pair(random);
    const Region sum = signed_sum_of(pair.p, pair.q);
    for (int k = 0; k < 40; ++k) {
      // The operands' edges rarely meet these sevenths.
      const reference::Pt x{reference::Number(random.below(600) - 200) / 7,
                            reference::Number(random.below(600) - 200) / 7};
      EXPECT_EQ(reference::locate(x, sum) != reference::Side::kOutside,
                reference::contains_sum(pair.p, pair.q, x))
          << i << ' ' << pair.kind << ' ' << x.x << ' ' << x.y;
    }
  }
}

Region moved_and_scaled(const Region& region, const Rational& scale, const Rational& shift) {
  return test::transformed(region, [&](const Point& p) {
    return Point{p.x * scale + shift, p.y * scale - shift};
  });
}

TEST(SignedConvolution, AnyNumbersGiveTheSameShape) {
  // These scales make fractions, integers of some 60 bits, and both.
  const Rational scales[] = {Rational(1, 3), Rational((std::int64_t{1} << 40) + 1),
                             Rational(std::int64_t{0x7fffffffffffff1}) / Rational(1000003)};
  const Rational far = Rational(std::int64_t{0x7fffffffffffff1}) * Rational(1000000007);
  for (int i = 0; i < 60; ++i) {
    test::Random random(static_cast<std::uint64_t>(900 + i));
    const test::Pair pair = test::random_pair(random);
    const Region sum = signed_sum_of(pair.p, pair.q);
    for (const Rational& scale : scales) {
      // A shift by 1/1009 makes the common grid finer still.
      const Region p = moved_and_scaled(pair.p, scale, far);
      const Region q = moved_and_scaled(pair.q, scale, Rational(1, 1009));
      EXPECT_EQ(signed_sum_of(p, q), moved_and_scaled(sum, scale, far + Rational(1, 1009))) << i;
    }
  }
}

TEST(SignedConvolution, CanBeStopped) {
  const Region square = test::parse_wkt(kSquare);
  Statistics statistics;
  Region result;
  SumSettings options;
  options.cancel.emplace();
  options.cancel->cancel();
  const auto code_of = [&](const Region& p) {
    try {
      signed_convolution_sum(p, square, options, statistics, result);
    } catch (const Error& error) {
      EXPECT_TRUE(result.empty());
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(code_of(square), ErrorCode::kCancelled);
  options.cancel.reset();
  for (const Stage last : {Stage::kOperands, Stage::kConvolution, Stage::kOverlay}) {
    options.progress = [last](const Progress& progress) { return progress.stage != last; };
    EXPECT_EQ(code_of(square), ErrorCode::kCancelled);
  }
  options.progress = nullptr;
  options.limits.max_crossings = 0;
  const Region cross = test::parse_wkt("POLYGON ((0 0, 9 4, 0 8, 3 4, 0 0))");
  EXPECT_EQ(code_of(cross), ErrorCode::kLimitExceeded);
}

TEST(SignedConvolution, ImpossibleWindingNumbersAreErrors) {
  // The ring winds clockwise around half of its points, which no valid region does.
  const Region bow_tie = test::parse_wkt("POLYGON ((0 0, 4 4, 4 0, 0 5, 0 0))");
  try {
    (void)signed_sum_of(bow_tie, test::parse_wkt("POLYGON ((0 0, 1 0, 0 1, 0 0))"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInternal);
    EXPECT_NE(std::string(error.what()).find("winding"), std::string::npos);
  }
}

TEST(SignedConvolution, CountsWhatItDid) {
  Statistics statistics;
  Region result;
  const Region square = test::parse_wkt(kSquare);
  signed_convolution_sum(square, square, SumSettings{}, statistics, result);
  EXPECT_EQ(statistics.convolution_segments, 8U);
  EXPECT_EQ(statistics.crossings, 0U);
  signed_convolution_sum(test::parse_wkt("POLYGON ((0 0, 9 4, 0 8, 3 4, 0 0))"), square,
                         SumSettings{}, statistics, result);
  EXPECT_EQ(statistics.crossings, 1U);
}

}  // namespace
}  // namespace minksum

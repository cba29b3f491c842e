#include "minksum/adaptors/clipper2.hpp"

#include <gtest/gtest.h>

#ifdef MINKSUM_TEST_CLIPPER2
#include <clipper2/clipper.h>
#endif
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "adaptors/sources.hpp"
#include "minksum/measure.hpp"
#include "minksum/round.hpp"

namespace minksum::test {
namespace {

using adaptors::from_clipper;
using adaptors::to_clipper;

#ifdef MINKSUM_TEST_CLIPPER2
using Clipper2Lib::PathsD, Clipper2Lib::Paths64;
#else
// These types have the shape of Clipper2's.
struct Point64 {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
struct PointD {
  double x = 0;
  double y = 0;
};
using Paths64 = std::vector<std::vector<Point64> >;
using PathsD = std::vector<std::vector<PointD> >;
#endif

template <class Paths>
class Clipper2 : public testing::Test {};
using Kinds = testing::Types<Paths64, PathsD>;
TYPED_TEST_SUITE(Clipper2, Kinds);

TYPED_TEST(Clipper2, RoundTrips) {
  Random random(seed_from_environment(21));
  for (int i = 0; i < 200; ++i) {
    const Region region = random_source(random);
    for (const Region& written : {region, scrambled(region, random)}) {
      const auto paths = to_clipper<TypeParam>(written);
      ASSERT_EQ(paths.size(), region.ring_count());
      for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero, FillRule::kPositive}) {
        ASSERT_EQ(from_clipper(paths, rule), region) << to_text(written);
      }
      ASSERT_TRUE(from_clipper(paths, FillRule::kNegative).empty());
    }
  }
}

// Coordinates are multiplied by the scale and divided again. Both are exact for integer products.
TYPED_TEST(Clipper2, Scales) {
  Random random(seed_from_environment(22));
  for (int i = 0; i < 50; ++i) {
    const Region region = scaled(random_source(random), Rational(1, 12));
    const auto paths = to_clipper<TypeParam>(region, Rational(12));
    EXPECT_EQ(from_clipper(paths, FillRule::kNonZero, Rational(12)), canonical(region));
    const auto more = to_clipper<TypeParam>(region, Rational(36));
    EXPECT_EQ(from_clipper(more, FillRule::kNonZero, Rational(36)), canonical(region));
  }
}

TYPED_TEST(Clipper2, FillsByTheRule) {
  // The two squares cross, and both are counter-clockwise. Each is closed in one of the two ways.
  const TypeParam paths{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, {{2, 2}, {6, 2}, {6, 6}, {2, 6}}};
  EXPECT_EQ(area(from_clipper(paths, FillRule::kNonZero)), Rational(28));
  EXPECT_EQ(area(from_clipper(paths, FillRule::kPositive)), Rational(28));
  EXPECT_EQ(area(from_clipper(paths, FillRule::kEvenOdd)), Rational(24));
  EXPECT_TRUE(from_clipper(paths, FillRule::kNegative).empty());
  // The bow tie crosses itself at a point without integer coordinates.
  const TypeParam bow{{{0, 0}, {3, 3}, {3, 0}, {0, 2}}};
  const Region both = from_clipper(bow, FillRule::kNonZero);
  EXPECT_EQ(both.polygon_count(), 2U);
  EXPECT_EQ(both.vertex_count(), 6U);
  for (const FillRule rule : {FillRule::kAutomatic, FillRule::kStrict}) {
    EXPECT_EQ(error_of([&] { (void)from_clipper(paths, rule); }).code(), ErrorCode::kBadInput);
  }
}

TYPED_TEST(Clipper2, NothingIsNothing) {
  EXPECT_TRUE(to_clipper<TypeParam>(Region()).empty());
  EXPECT_EQ(from_clipper(TypeParam(), FillRule::kNonZero), Region());
  // These paths have no area: empty, a point, a segment, and a path there and back.
  const TypeParam thin{{}, {{1, 1}}, {{1, 1}, {5, 5}}, {{1, 1}, {5, 5}, {9, 9}, {5, 5}}};
  EXPECT_EQ(from_clipper(thin, FillRule::kEvenOdd), Region());
  Region begun;
  begun.begin_polygon();
  begun.begin_ring();
  EXPECT_TRUE(to_clipper<TypeParam>(begun).empty());
}

TYPED_TEST(Clipper2, LeavesOutEmptyRings) {
  const auto paths = to_clipper<TypeParam>(with_empty_rings());
  EXPECT_EQ(paths.size(), 2U);
  EXPECT_EQ(from_clipper(paths, FillRule::kPositive), without_empty_rings());
  EXPECT_EQ(from_clipper(to_clipper<TypeParam>(hole_alone()), FillRule::kPositive), Region());
}

TYPED_TEST(Clipper2, RefusesScalesThatAreNotPositive) {
  for (const Rational& scale : {Rational(0), Rational(-1)}) {
    EXPECT_EQ(error_of([&] { (void)to_clipper<TypeParam>(Region(), scale); }).code(),
              ErrorCode::kBadInput);
    EXPECT_EQ(error_of([&] { (void)from_clipper(TypeParam(), FillRule::kNonZero, scale); }).code(),
              ErrorCode::kBadInput);
  }
}

TEST(Clipper2Integers, AreNeverRounded) {
  const Region region = scaled(frame_and_triangle(), Rational(1, 2));
  Error error = error_of([&] { (void)to_clipper<Paths64>(region); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "0 0 1");
  EXPECT_STREQ(error.what(), "the coordinate 9/2 is not an integer: polygon 0, ring 0, vertex 1");
  error = error_of([&] { (void)to_clipper<Paths64>(region, Rational(1, 3)); });
  EXPECT_STREQ(error.what(), "the coordinate 3/2 is not an integer: polygon 0, ring 0, vertex 1");
  EXPECT_EQ(to_clipper<Paths64>(region, Rational(2)).size(), 3U);

  // The error names the index of a hole's vertex in the region, although the path is reversed.
  Region hole = make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
  hole.begin_ring();
  hole.add_vertex(1, 1);
  hole.add_vertex(5, 1);
  hole.add_vertex(Rational(11, 2), 5);
  hole.add_vertex(1, 5);
  error = error_of([&] { (void)to_clipper<Paths64>(hole); });
  EXPECT_EQ(place_of(error), "0 1 2");

  // The coordinates have more than 53 bits.
  const std::int64_t large = (std::int64_t{1} << 61U) + 1;
  const Paths64 paths{{{-large, -large}, {large, -large}, {large, large}}};
  const Region wide = from_clipper(paths, FillRule::kNonZero);
  EXPECT_EQ(wide.exact_x(1), Rational(large));
  EXPECT_EQ(to_clipper<Paths64>(wide)[0][1].x, large);
  error = error_of([&] { (void)to_clipper<Paths64>(wide, Rational(4)); });
  EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
  EXPECT_EQ(place_of(error), "0 0 0");
  EXPECT_EQ(error.limit()->name, "integers");
}

// All coordinates are one double, so only the exact ones tell which way a ring goes.
TEST(Clipper2Integers, HaveTheDirectionOfTheExactRing) {
  const Rational large(std::int64_t{1} << 60U);
  const auto tiny = [&large](const Region& region) {
    return scaled(moved(region, large, large), Rational(1) / large);
  };
  const Rational scale = large * Rational(4);
  const auto there_and_back = [&scale](const Region& region) {
    return from_clipper(to_clipper<Paths64>(region, scale), FillRule::kPositive, scale);
  };
  Random random(seed_from_environment(25));
  for (int i = 0; i < 50; ++i) {
    const Region region = canonical(tiny(scaled(random_source(random), Rational(1, 1024))));
    ASSERT_EQ(region.x(0), 1);
    EXPECT_EQ(there_and_back(scrambled(region, random)), region);
  }
  // Both outlines are clockwise. The first vertex is as far left, or as far down, as a corner, but
  // is straight.
  for (const Outline& outline : {Outline{{0, 5}, {0, 9}, {9, 9}, {9, 0}, {0, 0}},
                                 Outline{{5, 0}, {0, 0}, {0, 9}, {9, 9}, {9, 0}}}) {
    EXPECT_EQ(there_and_back(tiny(make_polygon(outline))), tiny(rectangle(0, 0, 9, 9)));
  }
}

// As the page says, decimals become integers by a power of ten.
TEST(Clipper2Integers, TakeWhatWasRounded) {
  Random random(seed_from_environment(23));
  RoundOptions options;
  options.decimals = 2;
  for (int i = 0; i < 30; ++i) {
    const Region rounded = round(scaled(random_source(random), Rational(1, 7)), options);
    const auto paths = to_clipper<Paths64>(rounded, Rational(100));
    EXPECT_EQ(from_clipper(paths, FillRule::kEvenOdd, Rational(100)), rounded);
  }
}

TEST(Clipper2Doubles, AreTheNearest) {
  const Region region = scaled(frame_and_triangle(), Rational(1, 10));
  EXPECT_EQ(to_clipper<PathsD>(region)[0][1].x, 0.9);
  EXPECT_EQ(to_clipper<PathsD>(region, Rational(1, 3))[0][1].x, 0.3);
  // 1/10 comes back as the double, because a double means exactly itself.
  const Region back = from_clipper(to_clipper<PathsD>(region), FillRule::kNonZero);
  EXPECT_EQ(back.exact_x(1), Rational(0.9));
  EXPECT_EQ(error_of([&] {
              (void)to_clipper<PathsD>(region, Rational(Decimal{1, 400}));
            }).code(),
            ErrorCode::kLimitExceeded);
}

TEST(Clipper2Errors, NameThePath) {
  PathsD paths{{{0, 0}, {4, 0}, {4, 4}}, {}, {{0, 0}, {1, 0}, {2, 2}}};
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    paths[2][1].y = bad;
    const Error error = error_of([&] { (void)from_clipper(paths, FillRule::kNonZero); });
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(place_of(error), "2 0 1");
  }
}

#ifdef MINKSUM_TEST_CLIPPER2
// Both libraries agree on the meaning of paths if crossings are integers.
TEST(Clipper2Itself, MeansTheSame) {
  Random random(seed_from_environment(24));
  for (int i = 0; i < 100; ++i) {
    const auto a = to_clipper<Paths64>(random_cells(random, 5, 5, false, false));
    const auto b = to_clipper<Paths64>(random_cells(random, 5, 5, false, false));
    Paths64 both = a;
    both.insert(both.end(), b.begin(), b.end());
    EXPECT_EQ(
        from_clipper(Clipper2Lib::Union(both, Clipper2Lib::FillRule::NonZero), FillRule::kNonZero),
        from_clipper(both, FillRule::kNonZero));
  }
}
#endif

}  // namespace
}  // namespace minksum::test

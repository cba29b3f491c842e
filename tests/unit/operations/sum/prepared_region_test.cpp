// Tests that a prepared operand has the same sums as the region itself, with any other operand.
#include "minksum/prepared_region.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "minksum/testing.hpp"
#include "minksum/transform.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

/// Returns shapes whose coordinates need different scales and rungs; some have holes.
std::vector<Region> mixed_shapes() {
  Random random(7);
  std::vector<Region> shapes{random_two_opt(random, 25, 100), random_with_holes(random, 60, 3),
                             random_cells(random, 5, 5, true, false), comb(4, 2, 9),
                             frame({{{0, 0}, {50, 0}, {50, 50}, {0, 50}}}, 5)};
  const auto scaled = [](const Region& region, auto number) {
    Region result;
    for (const std::size_t polygon : region.polygons()) {
      result.begin_polygon();
      for (const std::size_t ring : region.rings_of(polygon)) {
        result.begin_ring();
        for (const std::size_t v : region.vertices_of(ring)) {
          result.add_vertex(number(region.x(v)), number(region.y(v)));
        }
      }
    }
    return result;
  };
  const auto integer = [](double x) { return static_cast<std::int64_t>(x); };
  shapes.push_back(scaled(shapes[0], [&](double x) { return Decimal{3 * integer(x) + 1, -5}; }));
  shapes.push_back(scaled(shapes[1], [](double x) { return x * 0x1.8p-20; }));
  shapes.push_back(scaled(shapes[3], [](double x) { return (x - 3) * 0x1.1p70; }));
  shapes.push_back(
      scaled(shapes[4], [&](double x) { return Rational(integer(x) - 7) / Rational(3); }));
  return shapes;
}

TEST(PreparedRegion, GivesWhatTheRegionsGive) {
  const std::vector<Region> shapes = mixed_shapes();
  std::vector<PreparedRegion> prepared(shapes.begin(), shapes.end());
  Workspace workspace;
  Region sum;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      SumSettings options;
      Region expected;
      for (const bool check : {false, true}) {  // with checks, the stages are used
        options.check = check;
        expected = minkowski_sum(shapes[i], shapes[j], options);
        ASSERT_TRUE(minkowski_sum(prepared[i], prepared[j], options, workspace, sum).ok());
        ASSERT_EQ(sum, expected) << i << " + " << j;
        for (std::size_t v = 0; v < sum.vertex_count(); ++v) {
          ASSERT_EQ(sum.origin(v).edge, expected.origin(v).edge);
          ASSERT_EQ(sum.origin(v).vertex, expected.origin(v).vertex);
        }
      }
      options.method = Method::kSigned;
      ASSERT_EQ(minkowski_sum(prepared[i], prepared[j], options), expected);
    }
  }
}

TEST(PreparedRegion, TakesLongDecimalsForWhatTheyAre) {
  // Twenty digits are more than a decimal of 64 bits has, and fewer than fixed-width integers have.
  const Rational x = Rational(1) / Rational(std::int64_t{1'000'000'000'000'000'000});
  const Rational y = x / Rational(40);
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [a, b] : {std::pair{0, 0}, {7, 1}, {5, 2}, {3, 9}, {-1, 4}}) {
    region.add_vertex(Rational(a) + x, Rational(b) - y);
  }
  const DetailedSum small = detailed_sum(region, region);
  EXPECT_TRUE(small.statistics.small);
  SumSettings options;
  options.small = false;
  const DetailedSum sum = detailed_sum(region, region, options);
  EXPECT_EQ(sum.statistics.arithmetic, Arithmetic::kWide);
  EXPECT_EQ(sum.sum, small.sum);
  options.arithmetic = Arithmetic::kArbitrary;
  const DetailedSum again = detailed_sum(region, region, options);
  EXPECT_EQ(sum.sum, again.sum);
  EXPECT_EQ(again.statistics.arithmetic, Arithmetic::kArbitrary);
}

/// Expects that all settings give the sum that rationals of any size give. Returns the rung of the
/// first setting.
Arithmetic expect_same_by_rationals(const Region& p, const Region& q) {
  SumSettings options;
  options.check = true;
  options.tight = true;
  const DetailedSum first = detailed_sum(p, q, options);
  const Region& sum = first.sum.region;
  const Arithmetic rung = first.statistics.arithmetic;
  EXPECT_EQ(minkowski_sum(PreparedRegion(p), PreparedRegion(q)), sum);
  const Geometry& expected_tight = first.tight;
  options.arithmetic = Arithmetic::kArbitrary;
  const DetailedSum by_rationals = detailed_sum(p, q, options);
  const Region& expected = by_rationals.sum.region;
  const Geometry& tight = by_rationals.tight;
  EXPECT_EQ(by_rationals.statistics.arithmetic, Arithmetic::kArbitrary);
  EXPECT_EQ(sum, expected) << to_text(p) << '\n' << to_text(q);
  EXPECT_EQ(tight, expected_tight) << to_text(p) << '\n' << to_text(q);
  for (std::size_t v = 0; v < std::min(sum.vertex_count(), expected.vertex_count()); ++v) {
    EXPECT_EQ(sum.origin(v), expected.origin(v));
  }
  return rung;
}

// Turned integers have a common denominator, so they are integers on a finer grid.
TEST(PreparedRegion, PutsCommonDenominatorsOnTheGrid) {
  Random random(11);
  const Rational halves[] = {{1, 2}, {-2, 3}, {5, 58}, {237, 239}, {1, 100003}};
  for (int i = 0; i < 60; ++i) {
    const Region p = random_with_holes(random, 30, 2);
    const Region q = random_two_opt(random, 9, 12);
    const Affine turn = Affine::rotation(halves[i % 5]);
    const Affine other = Affine::rotation(halves[i / 5 % 5]);
    const Region turned_q = transform(q, turn.after(Affine::translation({i, 7}, {-5, 3})));
    EXPECT_LT(expect_same_by_rationals(p, turned_q), Arithmetic::kArbitrary);
    EXPECT_LT(expect_same_by_rationals(transform(p, other), turned_q), Arithmetic::kArbitrary);
    EXPECT_LT(expect_same_by_rationals(turned_q, reflect(turned_q)), Arithmetic::kArbitrary);
    EXPECT_LT(expect_same_by_rationals(transform(p, Affine::scaling(Rational(0.3))), turned_q),
              Arithmetic::kArbitrary);
  }
}

// Sizes are compared in one unit. Here a square is 9/7 wide, and a hole is a hair wider, equally
// wide, or narrower.
TEST(PreparedRegion, ComparesSizesOnDifferentGrids) {
  const Region part = scaled(rectangle(0, 0, 9, 9), Rational(1, 7));
  const Rational whole(1'000'000'007);
  for (const int more : {-1, 0, 1}) {
    const Rational side = (Rational(9, 7) * whole + Rational(more)) / whole;
    const Polygon sheet{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}},
                        {{{0, 0}, {side, 0}, {side, side}, {0, side}}}};
    const DetailedSum found = detailed_sum(Region(sheet), part, {.tight = true});
    EXPECT_EQ(found.sum.region.hole_count(), more == 1 ? 1U : 0U);
    EXPECT_EQ(found.tight.points.size(), more == 0 ? 1U : 0U);
    expect_same_by_rationals(Region(sheet), part);
  }
}

// Rationals take denominators that are long or have no short common multiple.
TEST(PreparedRegion, LeavesOtherDenominatorsToRationals) {
  const auto triangle = [](std::int64_t a, std::int64_t b, std::int64_t c) {
    return Region(Polygon{{{0, 0}, {Rational(5, a), 0}, {Rational(1, b), Rational(7, c)}}, {}});
  };
  const Region small = triangle(3, 7, 11);
  EXPECT_EQ(expect_same_by_rationals(small, small), Arithmetic::kNarrow);
  const Region primes = triangle(1'000'003, 2'000'003, 4'000'037);
  EXPECT_EQ(expect_same_by_rationals(primes, small), Arithmetic::kArbitrary);
  const Region wide = triangle(1, 1, (std::int64_t{1} << 62) - 57);
  EXPECT_EQ(expect_same_by_rationals(wide, rectangle(0, 0, 1, 1)), Arithmetic::kWide);
  EXPECT_EQ(expect_same_by_rationals(wide, small), Arithmetic::kArbitrary);
  const Region beyond = triangle(1, 1, (std::int64_t{1} << 62) + 27);
  EXPECT_EQ(expect_same_by_rationals(beyond, rectangle(0, 0, 1, 1)), Arithmetic::kArbitrary);
}

TEST(PreparedRegion, ServesManyThreads) {
  MINKSUM_NEEDS_THREADS();
  const PreparedRegion p(comb(9, 3, 40));
  const PreparedRegion q(round_polygon(24, 50));
  const Region expected = minkowski_sum(p.region(), q.region());
  std::vector<Region> sums(4);
  std::vector<std::thread> threads;
  for (Region& sum : sums) {
    threads.emplace_back([&, copy = p] { sum = minkowski_sum(copy, q); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Region& sum : sums) EXPECT_EQ(sum, expected);
}

TEST(PreparedRegion, TakesTheEmptyRegion) {
  const PreparedRegion empty{Region()};
  EXPECT_TRUE(minkowski_sum(empty, PreparedRegion(rectangle(0, 0, 1, 1))).empty());
  EXPECT_TRUE(minkowski_sum(empty, empty).empty());
}

TEST(PreparedRegion, RefusesWhatIsNoOperand) {
  try {
    const PreparedRegion bow_tie(make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.culprit().operand, -1);
    EXPECT_EQ(error.culprit().ring, 0U);
  }
}

}  // namespace

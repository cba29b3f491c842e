// Tests the reference against hand-made sums, laws and membership, because it must be right itself.
#include "reference/brute_force.hpp"

#include <gtest/gtest.h>

#include "minksum/measure.hpp"
#include "reference/canonical.hpp"
#include "reference/membership.hpp"
#include "reference/validity.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace {

using minksum::Region;
using minksum::reference::brute_force_sum;
using minksum::reference::brute_force_union;
using minksum::reference::canonical;
using minksum::reference::canonical_fault;
using minksum::reference::contains_sum;
using minksum::reference::Side;
using namespace minksum::test;

TEST(BruteForce, SquareAndSquare) {
  EXPECT_EQ(brute_force_sum(rectangle(0, 0, 2, 3), rectangle(-1, 0, 1, 1)), rectangle(-1, 0, 3, 4));
}

TEST(BruteForce, EmptyOperandGivesEmptySum) {
  EXPECT_TRUE(brute_force_sum(Region{}, rectangle(0, 0, 1, 1)).empty());
}

TEST(BruteForce, TriangleAndItsMirrorMakeAHexagon) {
  const Region triangle = make_polygon({{0, 0}, {2, 0}, {0, 2}});
  const Region hexagon = make_polygon({{-2, 0}, {0, -2}, {2, -2}, {2, 0}, {0, 2}, {-2, 2}});
  EXPECT_EQ(brute_force_sum(triangle, scaled(triangle, -1)), hexagon);
}

TEST(BruteForce, SlackDecidesWhetherAHoleStays) {
  const Region ring = frame({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}}, 1);
  EXPECT_EQ(brute_force_sum(ring, rectangle(0, 0, 4, 4)), rectangle(-1, -1, 9, 9));
  EXPECT_EQ(brute_force_sum(ring, rectangle(0, 0, 3, 4)), rectangle(-1, -1, 8, 9));
  const Region with_hole =
      make_polygon({{-1, -1}, {8, -1}, {8, 8}, {-1, 8}}, {{{3, 3}, {3, 4}, {4, 4}, {4, 3}}});
  EXPECT_EQ(brute_force_sum(ring, rectangle(0, 0, 3, 3)), with_hole);
}

TEST(BruteForce, PartsThatTouchAtACornerStayApart) {
  const Region corners =
      make_region({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {{{4, 4}, {5, 4}, {5, 5}, {4, 5}}}});
  const Region sum = brute_force_sum(corners, rectangle(0, 0, 3, 3));
  EXPECT_EQ(sum,
            make_region({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, {{{4, 4}, {8, 4}, {8, 8}, {4, 8}}}}));
}

TEST(BruteForce, UnionOfOverlappingSquares) {
  const Region both = brute_force_union(rectangle(0, 0, 2, 2), rectangle(1, 0, 3, 2));
  EXPECT_EQ(both, rectangle(0, 0, 3, 2));
}

TEST(BruteForce, UnionWithASinglePointOrTheUnitPieceIsCanonicalForm) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Region p = random_region(random);
    EXPECT_EQ(brute_force_union(p, Region{}), canonical(p)) << "seed " << seed << to_text(p);
  }
}

TEST(BruteForce, AgreesWithMembershipNearEveryEdge) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    const Region sum = brute_force_sum(pair.p, pair.q);
    ASSERT_EQ(canonical_fault(sum), "") << "seed " << seed << ' ' << to_text(sum);
    const auto points =
        minksum::reference::points_near_edges(sum, minksum::reference::Number(1, 4096));
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 60) {
      const bool is_inside = minksum::reference::locate(points[i], sum) != Side::kOutside;
      EXPECT_EQ(contains_sum(pair.p, pair.q, points[i]), is_inside)
          << "seed " << seed << " at " << points[i].x << ' ' << points[i].y << "\nP "
          << to_text(pair.p) << "\nQ " << to_text(pair.q);
    }
  }
}

TEST(BruteForce, ObeysTheLaws) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const Region a = random_region(random);
    const Region b = random_region(random);
    const Region c = random_region(random);
    const Region sum = brute_force_sum(a, b);
    const std::string note = "seed " + std::to_string(seed);
    EXPECT_EQ(sum, brute_force_sum(b, a)) << note;
    EXPECT_EQ(canonical(moved(sum, 3, -7)), brute_force_sum(moved(a, 1, -2), moved(b, 2, -5)))
        << note;
    EXPECT_EQ(canonical(turned(sum)), brute_force_sum(turned(a), turned(b))) << note;
    const Region left = brute_force_sum(brute_force_union(a, b), c);
    const Region right = brute_force_union(brute_force_sum(a, c), brute_force_sum(b, c));
    EXPECT_EQ(left, right) << note;
  }
}

TEST(BruteForce, ArithmeticDoesNotMatter) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    const Region sum = brute_force_sum(pair.p, pair.q);
    for (const std::int64_t factor : {1000LL, 1000000007LL}) {
      EXPECT_EQ(scaled(sum, factor),
                brute_force_sum(scaled(pair.p, factor), scaled(pair.q, factor)))
          << "seed " << seed << " factor " << factor;
    }
  }
}

}  // namespace

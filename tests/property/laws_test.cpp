// Tests laws that every Minkowski sum obeys.
#include <gtest/gtest.h>

#include "minksum/measure.hpp"
#include "property/sums.hpp"
#include "reference/brute_force.hpp"
#include "reference/canonical.hpp"
#include "reference/membership.hpp"
#include "reference/validity.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;
using reference::brute_force_sum;
using reference::brute_force_union;
using reference::canonical;

constexpr std::uint64_t kCases = 400;

// Calls check(seed, random, pair) with many pairs.
template <class Check>
void for_pairs(Check&& check) {
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    Random random(seed * 7919);
    const Pair pair = random_pair(random);
    SCOPED_TRACE(note(seed * 7919, pair));
    check(random, pair);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Laws, Commutative) {
  for_pairs([](Random&, const Pair& pair) {
    EXPECT_EQ(minkowski_sum(pair.p, pair.q), minkowski_sum(pair.q, pair.p));
  });
}

TEST(Laws, Translation) {
  for_pairs([](Random& random, const Pair& pair) {
    const Rational dx(random.between(-1000, 1000), 7);
    const Rational dy(random.between(-1000, 1000), 3);
    EXPECT_EQ(minkowski_sum(moved(pair.p, dx, dy), moved(pair.q, -dy, dx)),
              moved(minkowski_sum(pair.p, pair.q), dx - dy, dy + dx));
  });
}

TEST(Laws, Scaling) {
  for_pairs([](Random& random, const Pair& pair) {
    for (const Rational& factor : {Rational(random.between(1, 9), 10), Rational(-1),
                                   Rational(random.between(-2000000000, -2), 1)}) {
      EXPECT_EQ(minkowski_sum(scaled(pair.p, factor), scaled(pair.q, factor)),
                canonical(scaled(minkowski_sum(pair.p, pair.q), factor)));
    }
  });
}

TEST(Laws, QuarterTurnsAndMirrors) {
  for_pairs([](Random&, const Pair& pair) {
    const Region sum = minkowski_sum(pair.p, pair.q);
    EXPECT_EQ(minkowski_sum(turned(pair.p), turned(pair.q)), canonical(turned(sum)));
    EXPECT_EQ(minkowski_sum(mirrored(pair.p), mirrored(pair.q)), canonical(mirrored(sum)));
  });
}

TEST(Laws, WritingDoesNotMatter) {
  for_pairs([](Random& random, const Pair& pair) {
    EXPECT_EQ(minkowski_sum(scrambled(pair.p, random), scrambled(pair.q, random)),
              minkowski_sum(pair.p, pair.q));
  });
}

TEST(Laws, DistributesOverUnion) {
  for_pairs([](Random& random, const Pair& pair) {
    const Region other = random_region(random);
    EXPECT_EQ(minkowski_sum(brute_force_union(pair.p, other), pair.q),
              brute_force_union(minkowski_sum(pair.p, pair.q), minkowski_sum(other, pair.q)));
    const Region apart = moved(other, 1000, 0);
    EXPECT_EQ(minkowski_sum(together(pair.p, apart), pair.q),
              brute_force_union(minkowski_sum(pair.p, pair.q), minkowski_sum(apart, pair.q)));
  });
}

TEST(Laws, AssociativeWithResultsAsOperands) {
  for_pairs([](Random& random, const Pair& pair) {
    const Region third = random_polygon(random);
    const Region left = minkowski_sum(minkowski_sum(pair.p, pair.q), third);
    EXPECT_EQ(left, minkowski_sum(pair.p, minkowski_sum(pair.q, third)));
    EXPECT_EQ(reference::canonical_fault(left), "");
  });
}

TEST(Laws, ContainsTheOperandIfTheOtherHasTheOrigin) {
  for_pairs([](Random& random, const Pair& pair) {
    const int r = random.between(1, 3);
    const Region square = rectangle(-r, -r, r, r);
    const Region sum = minkowski_sum(pair.p, square);
    EXPECT_EQ(brute_force_union(sum, pair.p), sum);
  });
}

TEST(Laws, ConvexSumsAreMergedEdges) {
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    Random random(seed);
    const Region p = random_convex(random, random.between(4, 40), 200);
    const Region q = random_convex(random, random.between(4, 40), 200);
    SCOPED_TRACE(note(seed, p, q));
    const Region sum = minkowski_sum(p, q);
    EXPECT_EQ(sum, brute_force_sum(p, q));
    EXPECT_EQ(sum.ring_count(), 1U);
    EXPECT_LE(sum.vertex_count(), p.vertex_count() + q.vertex_count());
  }
}

TEST(Laws, AreaIsMonotone) {
  for_pairs([](Random& random, const Pair& pair) {
    const Region sum = minkowski_sum(pair.p, pair.q);
    const Region more = brute_force_union(pair.q, random_region(random));
    EXPECT_GE(area(minkowski_sum(pair.p, more)), area(sum));
    // By the theorem of Brunn and Minkowski, the root of the area is superadditive.
    const Rational a = area(pair.p);
    const Rational b = area(pair.q);
    const Rational excess = area(sum) - a - b;
    EXPECT_GE(excess, 0);
    EXPECT_GE(excess * excess, Rational(4) * a * b);
  });
}

TEST(Laws, TinyOperandsAreAsExactAsLargeOnes) {
  for_pairs([](Random&, const Pair& pair) {
    const Region tiny = scaled(pair.q, Rational(1, 1000003));
    EXPECT_EQ(minkowski_sum(pair.p, tiny), brute_force_sum(pair.p, tiny));
  });
}

TEST(Laws, MembershipNearEdges) {
  for_pairs([](Random&, const Pair& pair) {
    const Region sum = minkowski_sum(pair.p, pair.q);
    const auto points = reference::points_near_edges(sum, reference::Number(1, 65536));
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 12) {
      EXPECT_EQ(reference::contains_sum(pair.p, pair.q, points[i]),
                reference::locate(points[i], sum) != reference::Side::kOutside);
    }
  });
}

TEST(Laws, EmptyOperands) {
  EXPECT_TRUE(minkowski_sum(Region{}, rectangle(0, 0, 1, 1)).empty());
  EXPECT_TRUE(minkowski_sum(rectangle(0, 0, 1, 1), Region{}).empty());
  EXPECT_TRUE(minkowski_sum(Region{}, Region{}).empty());
}

}  // namespace

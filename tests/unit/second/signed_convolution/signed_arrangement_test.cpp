#include <gtest/gtest.h>

#include "minksum/error.hpp"
#include "minksum/testing.hpp"
#include "second/signed_convolution/arrangement.hpp"
#include "second/signed_convolution/rings.hpp"
#include "second/signed_convolution/winding.hpp"
#include "support/data.hpp"
#include "support/generators.hpp"

namespace minksum::signed_sum {
namespace {

template <class N>
class SignedArrangement : public testing::Test {};
struct RungNames {
  template <class N>
  static std::string GetName(int) {
    if (std::is_same_v<N, NarrowNumbers>) return "Small";
    return std::is_same_v<N, MediumNumbers> ? "Medium" : "Arbitrary";
  }
};
using Rungs = testing::Types<NarrowNumbers, MediumNumbers, ArbitraryNumbers>;
TYPED_TEST_SUITE(SignedArrangement, Rungs, RungNames);

TYPED_TEST(SignedArrangement, OneNodeForOnePoint) {
  // Three segments pass (3, 3), where one of them starts, and two overlap.
  Cancellation never;
  Geometry<TypeParam> geometry(3, never);
  const auto segment = [&](int x0, int y0, int x1, int y1) {
    return geometry.add_segment(geometry.add_vertex(x0, y0), geometry.add_vertex(x1, y1));
  };
  segment(0, 0, 6, 6);
  segment(0, 6, 6, 0);
  segment(3, 3, 7, 3);
  segment(5, 3, 1, 3);
  EXPECT_EQ(geometry.node_count(), 8U);
  const SumSettings options;
  CrossingFinder<TypeParam> finder(geometry, options);
  finder.run();
  EXPECT_EQ(geometry.node_count(), 8U);
  EXPECT_EQ(finder.crossings(), 6U);  // every pair
}

TYPED_TEST(SignedArrangement, CrossingsThatCoincideAreOneNode) {
  // Four lines pass (7/2, 7/2), which is not a vertex, and another crossing is close by.
  Cancellation never;
  Geometry<TypeParam> geometry(3, never);
  const auto segment = [&](int x0, int y0, int x1, int y1) {
    return geometry.add_segment(geometry.add_vertex(x0, y0), geometry.add_vertex(x1, y1));
  };
  segment(0, 0, 7, 7);
  segment(0, 7, 7, 0);
  segment(0, 3, 7, 4);
  segment(3, 0, 4, 7);
  const SumSettings options;
  CrossingFinder<TypeParam> finder(geometry, options);
  finder.run();
  ASSERT_EQ(geometry.node_count(), 9U);
  const auto point = geometry.exact(8);
  const auto twice = [](const auto& n) { return widen<BigInteger>(n) * 2; };
  EXPECT_TRUE(twice(point.x) == widen<BigInteger>(point.d) * 7);
  EXPECT_TRUE(twice(point.y) == widen<BigInteger>(point.d) * 7);
  EXPECT_EQ(finder.crossings(), 6U);
  EXPECT_EQ(geometry.compare_x(8, geometry.add_vertex(3, 0)), 1);
  EXPECT_EQ(geometry.compare_x(8, geometry.add_vertex(4, 0)), -1);
}

// Keeps the results of all stages of one sum.
template <class N>
struct Stages {
  Stages(const Region& p, const Region& q)
      : operands(make_operands(p, q, never)),
        layers(make_layers(operands, never)),
        segments(signed_segments(operands, layers, options, never)),
        geometry(operands.bits, never),
        arrangement(ArrangementBuilder<N>(geometry, options, statistics).run(layers, segments)) {}
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  SumSettings options;
  Cancellation never;
  Statistics statistics;
  IntegerOperands operands;
  std::vector<Layer> layers;
  std::vector<SignedSegment> segments;
  Geometry<N> geometry;
  Arrangement arrangement;
};

TYPED_TEST(SignedArrangement, PiecesMeetOnlyAtNodesAndFormCycles) {
  for (int i = 0; i < 60; ++i) {
    test::Random random(static_cast<std::uint64_t>(i));
    const test::Pair pair = test::random_pair(random);
    Stages<TypeParam> stages(pair.p, pair.q);
    EXPECT_TRUE(is_balanced(stages.arrangement)) << i;
    const std::size_t before = stages.geometry.node_count();
    CrossingFinder<TypeParam> again(stages.geometry, stages.options);
    again.run();
    EXPECT_EQ(stages.geometry.node_count(), before) << i;
  }
}

TYPED_TEST(SignedArrangement, BalanceCheckRejectsEveryDamage) {
  const Region dart = test::parse_wkt("POLYGON ((0 0, 6 0, 6 6, 4 2, 0 0))");
  Stages<TypeParam> stages(dart, test::parse_wkt("POLYGON ((1 0, 5 1, 2 7, 3 2, 1 0))"));
  ASSERT_TRUE(is_balanced(stages.arrangement));
  for (std::size_t i = 0; i < stages.arrangement.pieces.size(); ++i) {
    Arrangement damaged = stages.arrangement;
    damaged.pieces[i].deltas_along_piece = !damaged.pieces[i].deltas_along_piece;
    EXPECT_FALSE(is_balanced(damaged)) << "turned " << i;
    damaged = stages.arrangement;
    damaged.pieces[i].first_delta = damaged.pieces[i].last_delta;
    EXPECT_FALSE(is_balanced(damaged)) << "emptied " << i;
  }
}

TYPED_TEST(SignedArrangement, WindingWalkRejectsImpossibleNumbers) {
  const Region square = test::parse_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  Stages<TypeParam> stages(square, square);
  for (Delta& delta : stages.arrangement.deltas) delta.change = -delta.change;
  ASSERT_TRUE(is_balanced(stages.arrangement));
  WindingTrace<TypeParam> walk(stages.geometry, stages.arrangement, stages.layers);
  EXPECT_THROW((void)walk.run(), Error);
}

TYPED_TEST(SignedArrangement, RingBuilderRejectsOpenBoundaries) {
  const Region square = test::parse_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  Stages<TypeParam> stages(square, square);
  InsideFlags inside =
      WindingTrace<TypeParam>(stages.geometry, stages.arrangement, stages.layers).run();
  RingBuilder<TypeParam> sound(stages.geometry, stages.arrangement, inside);
  EXPECT_EQ(sound.run().rings.size(), 1U);
  for (HalfEdge h = 0; h < inside.size(); ++h) {
    InsideFlags damaged = inside;
    damaged[h] = !damaged[h];
    RingBuilder<TypeParam> builder(stages.geometry, stages.arrangement, damaged);
    EXPECT_THROW((void)builder.run(), Error) << h;
  }
}

TEST(SignedWinding, AHoleTakesItsPairOutOfTheSum) {
  const IntegerRing ring;
  const std::vector<Layer> layers{
      {0, false, &ring, &ring}, {0, true, &ring, &ring}, {1, false, &ring, &ring}};
  WindingNumbers numbers(layers);
  EXPECT_FALSE(numbers.inside());
  numbers.add(0, 2);
  EXPECT_TRUE(numbers.inside());
  numbers.add(1, -1);
  EXPECT_FALSE(numbers.inside());
  numbers.add(2, 1);
  EXPECT_TRUE(numbers.inside());
  numbers.add(2, -1);
  numbers.add(1, 1);
  EXPECT_TRUE(numbers.inside());
  numbers.clear();
  EXPECT_FALSE(numbers.inside());
}

}  // namespace
}  // namespace minksum::signed_sum

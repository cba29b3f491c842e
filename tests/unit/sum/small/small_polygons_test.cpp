// Tests sums of small operands of which one has several polygons.
#include <gtest/gtest.h>

#include "minksum/testing.hpp"
#include "sum/small/small_sum.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::make_polygon;
using test::make_region;
using test::Outline;
using test::rectangle;
using test::to_text;

Outline box(std::int64_t min_x, std::int64_t min_y, std::int64_t max_x, std::int64_t max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

class SmallPolygons : public testing::Test {
 protected:
  void SetUp() override {
    if (!SmallOperand::kMayHaveSeveral) GTEST_SKIP() << "this module takes single polygons only";
  }

  /// Computes both sums P ⊕ Q and Q ⊕ P. Expects them to be small, or to need the stages. Small
  /// ones must equal those by the stages.
  static void expect_small(const Region& p, const Region& q, bool is_small = true) {
    for (const auto& [first, second] : {std::pair(p, q), std::pair(q, p)}) {
      SmallOperand a;
      SmallOperand b;
      ASSERT_TRUE(load_small(first, a));
      ASSERT_TRUE(load_small(second, b));
      SmallScratch scratch;
      Region sum;
      ASSERT_EQ(sum_small(a, b, scratch, sum), is_small) << to_text(first) << to_text(second);
      SumSettings settings;
      settings.small = false;
      const Region by_stages = minkowski_sum(first, second, settings);
      EXPECT_TRUE(!is_small || to_text(sum) == to_text(by_stages)) << to_text(sum);
      EXPECT_EQ(to_text(minkowski_sum(first, second)), to_text(by_stages));
    }
  }
};

TEST_F(SmallPolygons, HaveTheirRingsInOrder) {
  const Region region =
      make_region({{box(1, 2, 9, 9), {{3, 4}, {5, 4}, {5, 6}}}, {box(-3, 0, 0, 1)}});
  SmallOperand small;
  ASSERT_TRUE(load_small(region, small));
  EXPECT_EQ(small.outer_rings, 2U);
  EXPECT_EQ(small.ends, (std::vector<std::uint32_t>{4, 12, 19}));
  EXPECT_EQ(small.size, 12U);
  EXPECT_EQ(small.smallest, 8U);
  EXPECT_EQ(small.extent, (Vec<double>{12, 9}));
  EXPECT_EQ(small.least_extent, (Vec<double>{3, 1}));
  EXPECT_EQ(small.at()[0], (Vec<double>{4, 2}));
  EXPECT_FALSE(small.convex);
  std::vector<std::uint32_t> ring_of;
  std::vector<std::uint32_t> smallest;
  find_rings(small, ring_of, smallest);
  EXPECT_EQ(smallest, (std::vector<std::uint32_t>{0, 8}));
  EXPECT_EQ(ring_of[7], 0U);
  EXPECT_EQ(ring_of[8], 1U);
  EXPECT_EQ(ring_of[16], 2U);
  const SmallOperand::Ends ends = small.ends_of(false, 11);
  EXPECT_EQ(ends.from, 11U);
  EXPECT_EQ(ends.to, 8U);
  SmallBlocks memory;
  EXPECT_FALSE(is_clearly_valid(small, memory));  // that is left to the stages
}

TEST_F(SmallPolygons, StayApartOrGrowTogether) {
  const Region bricks = make_region({{box(0, 0, 4, 4)}, {box(7, 1, 9, 3)}, {box(0, 6, 3, 9)}});
  for (const std::int64_t size : {1, 2, 3, 4, 5}) {
    expect_small(bricks, make_polygon({{0, 0}, {size, 0}, {0, size}}));
  }
}

TEST_F(SmallPolygons, LieInHolesOfOthers) {
  const Region rings = make_region({{box(0, 0, 40, 40), box(4, 4, 36, 36)},
                                    {box(8, 8, 32, 32), box(12, 12, 28, 28)},
                                    {{{16, 16}, {24, 17}, {22, 24}}}});
  for (const std::int64_t size : {2, 3, 5, 9, 15, 19}) {
    expect_small(rings, make_polygon({{0, 0}, {size, 1}, {1, size}}));
  }
  // Holes into which the other operand does not fit are filled, with polygons inside of them.
  for (const std::int64_t size : {3, 5, 9}) expect_small(rings, rectangle(0, 0, 26 + size, 2));
  // A polygon that fits into a hole of the other operand leaves a hole, unless others fill it.
  const Region frame = make_polygon(box(0, 0, 30, 30), {{{4, 4}, {26, 5}, {5, 26}}});
  expect_small(make_region({{box(0, 0, 2, 2)}, {box(50, 0, 52, 3)}}), frame);
  expect_small(make_region({{box(0, 0, 2, 2)}, {box(5, 0, 7, 3)}}), frame);
}

TEST_F(SmallPolygons, LieInsideTheOtherOperandSomewhere) {
  // At some rings of the convolution, the turned second operand touches one of the small polygons
  // and holds the other one: these rings are inside.
  const Region specks = make_region({{{{0, 0}, {1, 0}, {0, 1}}}, {{{9, 1}, {10, 3}, {9, 2}}}});
  expect_small(specks, make_polygon({{0, 0}, {40, 3}, {37, 44}, {-2, 41}}));
  expect_small(specks, make_polygon(box(0, 0, 60, 60), {box(20, 20, 31, 30)}));
}

TEST_F(SmallPolygons, MayTouchAtAVertex) {
  // Where the turned square touches the island on its right, it is inside the frame.
  const Region frame = make_region(
      {{box(0, 0, 120, 120), {{50, 50}, {70, 60}, {50, 70}}}, {{{60, 59}, {70, 60}, {60, 61}}}});
  for (const std::int64_t size : {2, 7, 12}) {
    expect_small(frame, rectangle(0, 0, size, size));
    expect_small(frame,
                 make_polygon(box(0, 0, size + 8, size + 9), {box(1, 1, size + 2, size + 3)}));
  }
}

TEST_F(SmallPolygons, GoToTheStagesWhereSumsOnlyTouch) {
  const Region square = rectangle(0, 0, 2, 2);
  // Both sums have the vertex (5, 5), and else no common point.
  expect_small(make_region({{box(0, 0, 3, 3)}, {box(5, 5, 8, 8)}}), square, false);
  // Along an edge they become one.
  expect_small(make_region({{box(0, 0, 3, 3)}, {box(5, 0, 8, 3)}}), square);
  expect_small(make_region({{box(0, 0, 3, 3)}, {box(5, 2, 8, 9)}}), square);
}

TEST_F(SmallPolygons, AreOfOneOperand) {
  const Region two = make_region({{box(0, 0, 1, 1)}, {box(2, 0, 3, 1)}});
  expect_small(two, two, false);
}

}  // namespace
}  // namespace minksum

// Tests which regions are small operands.
#include "sum/small/small_operand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "minksum/transform.hpp"
#include "minksum/validity.hpp"
#include "region/rational_access.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"
#include "unit/sum/small/square_with_holes.hpp"

namespace minksum {
namespace {

using test::make_polygon;
using test::rectangle;
using test::with_holes;

bool is_small(const Region& region) {
  SmallOperand small;
  return read_small(region, small);
}

TEST(SmallOperand, IsOneSimplePolygon) {
  EXPECT_TRUE(is_small(rectangle(0, 0, 3, 2)));
  EXPECT_TRUE(is_small(test::comb(5, 1, 3)));  // the teeth end on one line
  EXPECT_TRUE(is_small(test::round_polygon(1 << 16, 100'000'000)));
  EXPECT_FALSE(is_small({}));
  EXPECT_FALSE(is_small(test::round_polygon((1 << 16) + 1, 100'000'000)));
  EXPECT_TRUE(is_small(make_polygon({{0, 0}, {9, 0}, {9, 9}}, {{{5, 1}, {6, 1}, {6, 2}}})));
}

TEST(SmallOperand, LeavesFaultsToTheStages) {
  EXPECT_FALSE(is_small(make_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})));          // crosses
  EXPECT_FALSE(is_small(make_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})));  // touches
  // A star that turns left everywhere and goes round twice.
  EXPECT_FALSE(is_small(make_polygon({{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}})));
  EXPECT_FALSE(is_small(make_polygon({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}})));  // spike
  EXPECT_FALSE(is_small(make_polygon({{0, 0}, {4, 0}, {4, 4}, {4, 0}, {0, 0}})));  // no area
  EXPECT_FALSE(is_small(make_polygon({{0, 0}, {1, 0}, {2, 0}})));                  // flat
  EXPECT_FALSE(
      is_small(make_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {4, 4}, {4, 0}})));  // overlaps
}

TEST(SmallOperand, LeavesLongSpikyRingsToASweep) {
  // All blocks of edges of a ring of spikes are near one another.
  const auto spikes = [](int count) {
    test::Outline outline;
    for (int k = 0; k < count; ++k) {
      const double radius = k % 2 == 0 ? 1e9 : 1e7;
      const double angle = 2 * std::numbers::pi * k / count;
      outline.push_back(
          {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
    }
    return make_polygon(outline);
  };
  EXPECT_TRUE(is_small(spikes(400)));
  EXPECT_FALSE(is_small(spikes(4'000)));
  EXPECT_TRUE(validate(spikes(4'000)).empty());
}

TEST(SmallOperand, HasHolesApart) {
  const test::Outline hole{{1, 1}, {4, 1}, {4, 4}, {1, 4}};
  EXPECT_TRUE(is_small(with_holes({hole})));
  EXPECT_TRUE(is_small(with_holes({hole, {{5, 1}, {6, 3}, {8, 8}, {5, 5}}})));
  EXPECT_TRUE(is_small(with_holes({{{1, 1}, {1, 2}, {1, 4}, {4, 4}, {4, 1}}})));
  EXPECT_FALSE(is_small(with_holes({hole, hole})));
  EXPECT_FALSE(is_small(with_holes({hole, {{2, 2}, {3, 2}, {3, 3}}})));          // in one
  EXPECT_FALSE(is_small(with_holes({{{2, 2}, {3, 2}, {3, 3}}, hole})));          // around one
  EXPECT_FALSE(is_small(with_holes({hole, {{4, 4}, {6, 4}, {6, 6}}})));          // touches one
  EXPECT_FALSE(is_small(with_holes({hole, {{3, 2}, {6, 2}, {6, 3}, {3, 3}}})));  // crosses one
  EXPECT_FALSE(is_small(with_holes({{{0, 3}, {3, 2}, {3, 3}}})));                // touches the ring
  EXPECT_FALSE(is_small(with_holes({{{8, 3}, {11, 3}, {8, 5}}})));               // crosses it
  EXPECT_FALSE(is_small(with_holes({{{12, 3}, {13, 3}, {12, 5}}})));             // outside
  EXPECT_FALSE(is_small(with_holes({{{2, 2}, {4, 2}, {2, 2}, {2, 4}}})));        // a spike
  EXPECT_FALSE(is_small(with_holes({{{1, 1}, {4, 4}, {4, 1}, {1, 4}}})));        // crosses itself
  EXPECT_FALSE(is_small(with_holes({{{1, 1}, {2, 2}, {3, 3}}})));                // flat
  // The hole is in the box of the outer ring, but not in the ring.
  const test::Outline l{{0, 0}, {9, 0}, {9, 2}, {2, 2}, {2, 9}, {0, 9}};
  EXPECT_FALSE(is_small(make_polygon(l, {{{5, 5}, {6, 5}, {6, 6}}})));
}

/// Appends the upper side of a comb from the right to the left. Its teeth are as high as
/// height(k) over y = `base`.
template <class Height>
void append_teeth(int teeth, std::int64_t base, Height height, test::Outline& outline) {
  for (int k = teeth; k-- > 0;) {
    const std::int64_t top = base + height(k);
    outline.insert(outline.end(),
                   {{4 * k + 2, base}, {4 * k + 2, top}, {4 * k, top}, {4 * k, base}});
  }
}

TEST(SmallOperand, HasNoEdgesThatMeetFarAlongTheRing) {
  static constexpr int kTeeth = 900;
  for (const bool mirrored : {false, true}) {
    // A spike goes from one tooth near an end, above all others, to a higher one near the other
    // end.
    const auto comb = [&](std::int64_t reach) {
      test::Outline outline{{-5, -1}, {4 * kTeeth, -1}, {4 * kTeeth, 0}};
      append_teeth(
          kTeeth, 0, [](int k) { return k == 5 ? 100 : 10; }, outline);
      const auto tooth = std::find_if(outline.begin(), outline.end(), [](const test::Vertex& at) {
        return at.x == 4 * (kTeeth - 6) + 2 && at.y == 10;
      });
      outline.insert(tooth + 1, {reach, 50});
      if (mirrored) {
        for (auto& at : outline) at.x = -at.x;
        std::reverse(outline.begin(), outline.end());
      }
      return make_polygon(outline);
    };
    EXPECT_TRUE(is_small(comb(23)));
    EXPECT_FALSE(is_small(comb(22)));  // touches
    EXPECT_FALSE(is_small(comb(21)));  // crosses
  }
}

TEST(SmallOperand, HasNoHoleThatTouchesItsRingFarAlong) {
  static constexpr int kTeeth = 450;
  for (const int at : {3, kTeeth / 2, kTeeth - 4}) {
    const auto plate = [&](int depth) {
      test::Outline outer{{-5, 0}, {4 * kTeeth + 5, 0}, {4 * kTeeth + 5, 1000}};
      append_teeth(
          kTeeth, 1000, [&](int k) { return k == at ? -depth : -10; }, outer);
      outer.push_back({-5, 1000});
      test::Outline hole{{-1, 800}, {-1, 10}, {4 * kTeeth + 1, 10}, {4 * kTeeth + 1, 800}};
      append_teeth(
          kTeeth, 800, [](int) { return 10; }, hole);
      return make_polygon(outer, {hole});
    };
    EXPECT_TRUE(is_small(plate(189)));
    EXPECT_FALSE(is_small(plate(190)));
  }
}

TEST(SmallOperand, HasNoManyHoles) {
  const auto plate = [](int holes) {
    std::vector<test::Outline> all;
    for (int k = 0; k < holes; ++k) {
      all.push_back({{4 * k + 1, 1}, {4 * k + 2, 1}, {4 * k + 2, 2}});
    }
    return make_polygon({{0, 0}, {400, 0}, {400, 3}, {0, 3}}, all);
  };
  EXPECT_TRUE(is_small(plate(SmallOperand::kMaxHoles)));
  EXPECT_FALSE(is_small(plate(SmallOperand::kMaxHoles + 1)));
}

TEST(SmallOperand, HasIntegers) {
  Region quotients;
  quotients.begin_polygon();
  quotients.begin_ring();
  quotients.add_vertex(Rational(1, 3), Rational(0));
  quotients.add_vertex(1, 0);
  quotients.add_vertex(1, 1);
  EXPECT_FALSE(is_small(quotients));
  const std::int64_t far = std::int64_t{1} << 60;
  const auto is_wide = [](const Region& region) {
    SmallOperand small;
    EXPECT_TRUE(read_small(region, small));
    return small.is_wide();
  };
  EXPECT_FALSE(is_wide(rectangle(far - 5, 0, far, 1)));
  EXPECT_TRUE(is_wide(rectangle(far, 0, far + 5, 1)));
  EXPECT_FALSE(is_wide(rectangle(0, 0, std::int64_t{1} << 49, 1)));
  EXPECT_TRUE(is_wide(rectangle(0, 0, (std::int64_t{1} << 49) + 1, 1)));
  // The corners are so far apart that 64 bits do not hold their difference.
  EXPECT_TRUE(is_wide(rectangle(-7 * far, 0, 7 * far, 1)));
  const auto wide = [](int bits) {
    return transform(rectangle(0, 0, 1, 1), Affine{1, 0, 0, 0, Rational(std::ldexp(1, bits)), 0});
  };
  EXPECT_TRUE(is_wide(wide(124)));
  EXPECT_EQ(is_small(wide(126)), SmallOperand::kMayBeLong);
  EXPECT_EQ(is_small(wide(249)), SmallOperand::kMayBeLong);
  EXPECT_FALSE(is_small(wide(251)));
  // A power of three takes more than 64 bits, whatever powers of two and ten are taken from it.
  const auto far_by_threes = [](int threes) {
    Rational by(1);
    for (int k = 0; k < threes; ++k) by = by * Rational(3);
    return transform(rectangle(0, 0, 5, 1), Affine{1, 0, 0, 1, by, -by});
  };
  EXPECT_TRUE(is_wide(far_by_threes(50)));
  EXPECT_EQ(is_small(far_by_threes(90)), SmallOperand::kMayBeLong);
  EXPECT_FALSE(is_small(far_by_threes(160)));
}

/// Returns an outline of doubles that are rounded, so that its grid is fine.
Region turned_in_doubles(const test::Outline& outline) {
  std::vector<std::array<double, 2>> points;
  for (const auto& [x, y] : outline) {
    const auto fx = static_cast<double>(x);
    const auto fy = static_cast<double>(y);
    points.push_back({0.8 * fx - 0.6 * fy, 0.6 * fx + 0.8 * fy});
  }
  return Region::from_points(points);
}

/// Expects that an operand's vectors are these times its steps, exactly and nearly.
void expect_vector(const SmallOperand& operand, const VecRow& row, std::uint32_t i,
                   const Vec<Int128>& expected) {
  const auto steps = static_cast<double>(operand.steps);
  EXPECT_DOUBLE_EQ(row[i].x, static_cast<double>(expected.x) * steps);
  EXPECT_DOUBLE_EQ(row[i].y, static_cast<double>(expected.y) * steps);
  const Vec<WideNumber> exact = row.exact<WideNumber>(i);
  EXPECT_EQ(exact.x, product<WideNumber>(expected.x, operand.steps));
  EXPECT_EQ(exact.y, product<WideNumber>(expected.y, operand.steps));
}

/// Expects that the edges of an operand of one ring follow from its vertices.
void expect_edges(const SmallOperand& operand) {
  for (std::uint32_t v = 0; v < operand.size; ++v) {
    const std::uint32_t next = v + 1 == operand.size ? 0 : v + 1;
    const Vec<Int128> at = operand.whole_at(v);
    const Vec<Int128> way = minus(operand.whole_at(next), at);
    expect_vector(operand, operand.at(), v, at);
    expect_vector(operand, operand.way(), v, way);
    if (operand[SmallOperand::kOutX][v] != 0) expect_vector(operand, operand.out(), v, way);
    if (operand[SmallOperand::kInX][next] != 0) expect_vector(operand, operand.in(), next, way);
  }
}

TEST(SmallOperand, HasExactEdgesIfItIsWide) {
  const Region region = turned_in_doubles({{-1, 3}, {5, 3}, {5, 9}, {2, 4}});
  SmallOperand small;
  ASSERT_TRUE(read_small(region, small));
  ASSERT_TRUE(small.is_wide());
  expect_edges(small);
  SmallOperand fine;
  refine(small.exp2 - 3, small.exp10 - 1, small.entries, small, fine);
  EXPECT_EQ(static_cast<int>(fine.steps), 80);
  expect_edges(fine);
  SmallOperand turned;
  turn(fine, 3, turned);
  expect_edges(turned);
  for (std::uint32_t v = 0; v < small.size; ++v) {
    const Vec<Int128> at = small.whole_at(v);
    EXPECT_TRUE(fine.whole_at(v).x == at.x);
    // Three quarters of a turn bring (x, y) to (y, width - x).
    EXPECT_TRUE(turned.whole_at(v).x == at.y);
    EXPECT_TRUE(turned.whole_at(v).y == small.whole_extent.x - at.x);
  }
}

/// Returns a region that is a little larger and moved, so that its coordinates have some 180 bits.
Region with_long_coordinates(const Region& region) {
  const Rational by(1'000'000'000'000'000'003, 1'000'000'000'000'000'000);
  const Rational step(1, std::int64_t{1} << 60);
  return transform(region, Affine{by * by, 0, 0, by * by, Rational(-7) + step, Rational(5) - step});
}

TEST(SmallOperand, HasExactEdgesIfItIsLong) {
  if (!SmallOperand::kMayBeLong) GTEST_SKIP() << "this module takes no long operands";
  const Region region = with_long_coordinates(
      make_polygon({{0, 0}, {9, 2}, {9, 9}, {4, 5}, {0, 9}}, {{{2, 2}, {3, 4}, {4, 2}}}));
  SmallOperand small;
  ASSERT_TRUE(read_small(region, small) && small.is_long());
  // Expects that the operand's vertices are those of a region, and that edges follow from these.
  const auto expect_region = [](const SmallOperand& operand, const Region& expected) {
    const Vec<WideNumber> offset = operand.exact_offset<WideNumber>();
    const auto place = [&](const WideNumber& at, const WideNumber& by) {
      return RationalAccess::make(BigInteger(at + by), 1, operand.exp2, operand.exp10);
    };
    const auto expect_near = [](double near, const WideNumber& exact) {
      EXPECT_LE(std::abs(near - to_double(exact)), 0x1p-50 * std::abs(near));
    };
    std::uint32_t checked = 0;
    for (std::uint32_t v = 0; v < operand.entries; ++v) {
      const auto [from, to] = operand.ends_of(false, v);
      if (from == to) continue;  // between rings
      const Vec<WideNumber> at = operand.at().exact<WideNumber>(v);
      const double source = operand[SmallOperand::kVertexSource][v];
      const Point p = expected.point(static_cast<std::size_t>(source));
      EXPECT_TRUE(place(at.x, offset.x) == p.x && place(at.y, offset.y) == p.y) << v;
      const Vec<WideNumber> way = minus(operand.at().exact<WideNumber>(to), at);
      EXPECT_TRUE(operand.way().exact<WideNumber>(v) == way);
      expect_near(operand.at()[v].x, at.x);
      expect_near(operand.at()[v].y, at.y);
      expect_near(operand.way()[v].x, way.x);
      expect_near(operand.way()[v].y, way.y);
      ++checked;
    }
    EXPECT_EQ(checked, expected.vertex_count());
  };
  expect_region(small, region);
  SmallOperand fine;
  refine(small.exp2 - 30, small.exp10 - 4, small.entries, small, fine);
  ASSERT_NE(static_cast<std::int64_t>(fine.steps), 1);
  for (int quarters = 0; quarters < 4; ++quarters) {
    SmallOperand turned;
    turn(fine, quarters, turned);
    expect_region(turned, transform(region, Affine::quarter_turns(quarters)));
  }
}

TEST(SmallOperand, HasFaultsIfItIsLong) {
  const auto is_valid = [](const Region& r) { return is_small(with_long_coordinates(r)); };
  const test::Outline outline{{0, 0}, {9, 2}, {9, 9}, {4, 5}, {0, 9}};
  EXPECT_EQ(is_valid(make_polygon(outline)), SmallOperand::kMayBeLong);
  EXPECT_FALSE(is_valid(make_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})));          // crosses
  EXPECT_FALSE(is_valid(make_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})));  // touches
  EXPECT_FALSE(is_valid(make_polygon({{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}})));
  EXPECT_FALSE(is_valid(make_polygon({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}})));  // spike
  EXPECT_FALSE(is_valid(make_polygon(outline, {{{1, 1}, {9, 4}, {8, 3}}})));       // touches
  EXPECT_FALSE(is_valid(make_polygon(outline, {{{3, 8}, {5, 8}, {4, 6}}})));       // outside
}

TEST(SmallOperand, HasExactEdgesOnAFineGrid) {
  const std::int64_t far = (std::int64_t{1} << 49) - 1;
  const Region region = make_polygon({{-3, 1}, {far - 3, 7}, {far - 4, far}, {far / 3, far / 7}});
  SmallOperand small;
  ASSERT_TRUE(read_small(region, small));
  ASSERT_FALSE(small.is_wide());
  expect_edges(small);
  SmallOperand turned;
  for (const int tens : {0, 9, 25}) {
    for (const int twos : {3, 40}) {
      SmallOperand fine;
      refine(-twos, -tens, small.entries, small, fine);
      for (int quarters = 0; quarters < 4; ++quarters) {
        turn(fine, quarters, turned);
        expect_edges(turned);
      }
      for (std::uint32_t v = 0; v < small.size; ++v) {
        EXPECT_TRUE(fine.whole_at(v).x == small.whole_at(v).x);
        EXPECT_TRUE(fine.whole_at(v).y == small.whole_at(v).y);
      }
    }
  }
}

TEST(SmallOperand, KnowsWhereItsVerticesAreFrom) {
  // The ring is clockwise, with a vertex in the middle of an edge.
  const Region region = make_polygon({{5, 7}, {5, 9}, {8, 9}, {8, 7}, {6, 7}});
  SmallOperand small;
  ASSERT_TRUE(read_small(region, small));
  ASSERT_EQ(small.size, 4U);
  EXPECT_TRUE(small.convex);
  EXPECT_EQ(small.first.x, 5);
  EXPECT_EQ(small.first.y, 7);
  for (std::uint32_t v = 0; v < small.size; ++v) {
    const std::uint32_t from = static_cast<std::uint32_t>(small[SmallOperand::kVertexSource][v]);
    EXPECT_EQ(region.x(from), small[SmallOperand::kX][v] + static_cast<double>(small.offset.x));
    EXPECT_EQ(region.y(from), small[SmallOperand::kY][v] + static_cast<double>(small.offset.y));
    // In the reversed ring, the edge to the next vertex is the one that ends here.
    const std::uint32_t next =
        static_cast<std::uint32_t>(small[SmallOperand::kVertexSource][(v + 1) % 4]);
    EXPECT_EQ(static_cast<std::uint32_t>(small[SmallOperand::kEdgeSource][v]), next);
  }
}

TEST(SmallOperand, DropsRepeatedVertices) {
  // The last of equal vertices stays, and of those at the ring's end, the one at its start.
  const Region region =
      make_polygon({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}, {0, 0}, {0, 0}});
  SmallOperand small;
  ASSERT_TRUE(read_small(region, small));
  ASSERT_EQ(small.size, 4U);
  for (const auto row : {SmallOperand::kVertexSource, SmallOperand::kEdgeSource}) {
    EXPECT_EQ(static_cast<std::uint32_t>(small[row][0]), 1U);
    EXPECT_EQ(static_cast<std::uint32_t>(small[row][1]), 2U);
    EXPECT_EQ(static_cast<std::uint32_t>(small[row][2]), 5U);
    EXPECT_EQ(static_cast<std::uint32_t>(small[row][3]), 6U);
  }
}

TEST(SmallOperand, TurnsAsItsRegionDoes) {
  const Region region = make_polygon({{1, 2}, {9, 3}, {4, 4}, {5, 9}, {0, 7}});
  SmallOperand given;
  ASSERT_TRUE(read_small(region, given));
  for (int quarters = 0; quarters < 4; ++quarters) {
    SmallOperand turned;
    turn(given, quarters, turned);
    SmallOperand expected;
    ASSERT_TRUE(read_small(transform(region, Affine::quarter_turns(quarters)), expected));
    EXPECT_EQ(turned.size, expected.size);
    EXPECT_EQ(turned.smallest, expected.smallest);
    EXPECT_EQ(turned.offset.x, expected.offset.x);
    EXPECT_EQ(turned.offset.y, expected.offset.y);
    EXPECT_EQ(turned.extent.x, expected.extent.x);
    EXPECT_EQ(turned.extent.y, expected.extent.y);
    EXPECT_EQ(turned.longest, expected.longest);
    for (int row = 0; row < SmallOperand::kRows; ++row) {
      for (std::uint32_t v = 0; v < turned.size; ++v) {
        const auto at = static_cast<SmallOperand::Row>(row);
        EXPECT_EQ(turned[at][v], expected[at][v]) << quarters << ", row " << row << ", " << v;
      }
    }
  }
}

}  // namespace
}  // namespace minksum

// Tests polylines as operands by both methods, as walks there and back, and checkers that reject.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "region/map_points.hpp"
#include "second/signed_convolution/segments.hpp"
#include "sum/convolution/convolution.hpp"
#include "support/geometries.hpp"
#include "unit/second/signed_convolution/fault_of_operands.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

/// A region or polylines as a prepared operand, with their sources.
struct Made {
  Region region;
  PreparedOperand operand;
  explicit Made(const Region& area) : region(area) {
    Cancellation never;
    OperandScratch scratch;
    std::vector<Fault> faults;
    prepare_operand(region, {}, 1, never, scratch, operand, faults);
    EXPECT_TRUE(faults.empty());
  }
  explicit Made(const std::vector<Outline>& polylines) {
    Cancellation never;
    OperandScratch scratch;
    walk_there_and_back(make_lines(polylines).polylines, never, region);
    prepare_thin_operand(region, {}, never, scratch, operand);
  }
};

const Region kTriangle = make_polygon({{0, 0}, {3, 0}, {1, 2}});
const std::vector<Outline> kHook{{{0, 0}, {4, 0}, {4, 3}, {2, 3}}, {{5, 5}, {6, 7}}};

TEST(ThinOperand, IsWalkedThereAndBack) {
  const Made hook(kHook);
  EXPECT_EQ(to_text(hook.region),
            to_text(make_region(
                {{{{0, 0}, {4, 0}, {4, 3}, {2, 3}, {4, 3}, {4, 0}}}, {{{5, 5}, {6, 7}}}})));
  // The walk turns left at both ends, and once at each inner vertex.
  EXPECT_EQ(hook.operand.convex, (std::vector<std::uint8_t>{1, 1, 1, 1, 0, 0, 1, 1}));
  ASSERT_EQ(hook.operand.rings.size(), 2U);
  EXPECT_EQ(hook.operand.rings[1].begin, 6U);
  EXPECT_EQ(hook.operand.rings[1].end, 8U);
}

TEST(ThinOperand, AClosedPolylineIsCutAtItsFirstVertex) {
  const Made square({{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}});
  EXPECT_EQ(square.region.vertex_count(), 8U);
  EXPECT_EQ(square.operand.convex, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0, 0, 0}));
}

TEST(ThinOperand, TheCheckerKnowsEndsFromSpikes) {
  const Made triangle(kTriangle);
  const Made hook(kHook);
  const auto combined = [&] {
    Operands operands;
    Cancellation never;
    combine_operands(triangle.operand, hook.operand, {}, NarrowHoles::kFill, never, operands);
    return operands;
  };
  EXPECT_EQ(check(combined()), std::nullopt);
  const auto rejects = [&](auto damage) {
    Operands operands = combined();
    damage(operands);
    return check(operands).has_value();
  };
  EXPECT_TRUE(rejects([](Operands& o) { o.convex[o.split] = 0; }));
  EXPECT_TRUE(rejects([](Operands& o) { o.convex[o.split + 4] = 1; }));
  EXPECT_TRUE(rejects([](Operands& o) { o.thin[1] = false; }));
}

TEST(ThinOperand, EndsTakeHalfACircleOfDirections) {
  const Made triangle(kTriangle);
  const Made segment({{{0, 0}, {5, 1}}});
  Operands operands;
  Cancellation never;
  combine_operands(triangle.operand, segment.operand, {}, NarrowHoles::kFill, never, operands);
  EXPECT_TRUE(operands.both_convex);
  ConvolutionScratch scratch;
  Convolution convolution;
  reduced_convolution(operands, {}, never, scratch, convolution);
  EXPECT_EQ(check(convolution, operands, false), std::nullopt);
  // Both edges of the walk and all edges of the triangle make one segment each.
  EXPECT_EQ(convolution.segments.size(), 5U);
  convolution.segments.pop_back();
  EXPECT_TRUE(check(convolution, operands, false).has_value());
}

Operands combined(const std::vector<Outline>& p, const std::vector<Outline>& q) {
  Operands operands;
  Cancellation never;
  combine_operands(Made(p).operand, Made(q).operand, {}, NarrowHoles::kFill, never, operands);
  return operands;
}
std::vector<Polyline> parallel_sums(const std::vector<Outline>& p, const std::vector<Outline>& q,
                                    const Limits& limits = {}) {
  const std::array<Region, 2> walks{Made(p).region, Made(q).region};
  Cancellation never;
  std::vector<Polyline> sums;
  list_parallel_sums(combined(p, q), walks, limits, never, sums);
  return sums;
}

TEST(ThinOperand, BetweenTwoOfThemParallelEdgesAreLeftOut) {
  const auto segments_of = [](const std::vector<Outline>& p, const std::vector<Outline>& q) {
    const Operands operands = combined(p, q);
    Cancellation never;
    ConvolutionScratch scratch;
    Convolution convolution;
    reduced_convolution(operands, {}, never, scratch, convolution);
    EXPECT_EQ(check(operands), std::nullopt);
    EXPECT_EQ(check(convolution, operands, false), std::nullopt);
    return convolution.segments.size();
  };
  const std::vector<Outline> across{{{0, 0}, {3, 0}}};
  EXPECT_EQ(segments_of(across, {{{0, 0}, {0, 2}}}), 4U);
  EXPECT_EQ(segments_of(across, {{{0, 0}, {7, 0}}}), 0U);
  // The corner of the L takes the edge that is parallel to one of its own; its far end does not.
  EXPECT_EQ(segments_of(across, {{{0, 0}, {7, 0}, {7, 4}}}), 4U);
}

TEST(ThinOperand, ParallelSumsAreListedOncePerPair) {
  const std::vector<Outline> p{{{0, 0}, {3, 0}, {3, 2}}};
  const std::vector<Outline> q{{{0, 0}, {-7, 0}}, {{5, 5}, {6, 5}}, {{0, 0}, {1, 1}}};
  EXPECT_EQ(to_text(Geometry{{}, parallel_sums(p, q), {}}),
            to_text(make_lines({{{-7, 0}, {3, 0}}, {{5, 5}, {9, 5}}})));
  Limits limits;
  limits.max_segments = 1;
  EXPECT_THROW(static_cast<void>(parallel_sums(p, q, limits)), Error);
}

/// Both pieces of a parallel sum are sides of parallelograms if polylines bend at the right ends.
TEST(ThinOperand, ParallelSumsWithinTheAreaAreLeftOut) {
  const auto count = [](const Outline& p, const Outline& q) {
    return parallel_sums({p}, {q}).size();
  };
  const Outline both{{-1, 5}, {0, 0}, {3, 0}, {4, 5}};
  const Outline left{{0, 7}, {0, 0}, {3, 0}};
  const Outline right{{0, 0}, {3, 0}, {2, 9}};
  const Outline none{{0, 0}, {2, 0}};
  EXPECT_EQ(count(both, left), 0U);
  EXPECT_EQ(count(right, both), 0U);
  EXPECT_EQ(count(left, right), 0U);
  EXPECT_EQ(count(left, {{1, 9}, {0, 0}, {2, 0}}), 1U);  // no side ends on the right
  EXPECT_EQ(count(right, right), 2U);                    // each pair ends alike
  EXPECT_EQ(count(both, none), 1U);
}

TEST(SignedThinOperand, IsClosedAndChecked) {
  using namespace minksum::signed_sum;
  const Geometry hook = make_lines(kHook);
  Cancellation never;
  Region walks;
  walk_there_and_back(hook.polylines, never, walks);
  const DirectedOperands operands = make_operands(kTriangle, walks, never);
  EXPECT_EQ(fault_of(operands), "");
  EXPECT_NO_THROW((void)signed_convolutions(operands, UINT64_MAX, never));
  const auto rejects = [&](auto damage) {
    DirectedOperands damaged = make_operands(kTriangle, walks, never);
    damage(damaged.q[0][0]);
    return !fault_of(damaged).empty();
  };
  EXPECT_TRUE(rejects([](DirectedRing& walk) { walk.convex[0] = false; }));
  EXPECT_TRUE(rejects([](DirectedRing& walk) { walk.convex[4] = true; }));
  EXPECT_TRUE(rejects([](DirectedRing& walk) { std::swap(walk.vertices[4], walk.vertices[0]); }));
  EXPECT_TRUE(rejects(
      [](DirectedRing& walk) { std::reverse(walk.vertices.begin(), walk.vertices.end()); }));
}

}  // namespace

#include <gtest/gtest.h>

#include "minksum/error.hpp"
#include "second/signed_convolution/operands.hpp"
#include "second/signed_convolution/segments.hpp"
#include "support/data.hpp"
#include "support/generators.hpp"
#include "unit/second/signed_convolution/fault_of_operands.hpp"

namespace minksum::signed_sum {
namespace {

/// The convolution of the outer rings of the first parts.
struct Convolution {
  explicit Convolution(const char* p, const char* q)
      : first(test::parse_wkt(p)),
        second(test::parse_wkt(q)),
        operands(make_operands(first, second, never)),
        segments(signed_segments(operands.p[0][0], operands.q[0][0], operands.direction_count,
                                 UINT64_MAX, never)) {}
  Convolution(const Convolution&) = delete;
  Convolution& operator=(const Convolution&) = delete;

  /// Tells whether segments between sums of these rings' vertices form closed chains.
  [[nodiscard]] bool closes(const std::vector<SignedSegment>& changed) {
    Region chains;
    chains.begin_polygon();
    try {
      link_segments(operands.p[0][0], operands.q[0][0], changed, never, chains);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInternal);
      return false;
    }
    EXPECT_EQ(chains.vertex_count(), changed.size());
    return true;
  }

  Cancellation never;
  Region first;
  Region second;
  DirectedOperands operands;
  std::vector<SignedSegment> segments;
};

Region convolutions_of(const Region& p, const Region& q) {
  Cancellation never;
  const DirectedOperands operands = make_operands(p, q, never);
  EXPECT_EQ(fault_of(operands), "");
  return signed_convolutions(operands, UINT64_MAX, never);
}
std::size_t segments_of(const char* p, const char* q) {
  return convolutions_of(test::parse_wkt(p), test::parse_wkt(q)).vertex_count();
}

constexpr const char* kSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
constexpr const char* kDart = "POLYGON ((0 0, 6 0, 6 6, 4 2, 0 0))";
constexpr const char* kFrame = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 7 2, 7 7, 2 7, 2 2))";

TEST(SignedOperands, AreOrientedAndCleaned) {
  // The ring is clockwise, with a repeated vertex, and with straight vertices also at the start.
  const Region messy = test::parse_wkt("POLYGON ((2 0, 0 0, 0 4, 0 4, 2 4, 4 4, 4 0, 3 0, 2 0))");
  Cancellation never;
  const Region frame = test::parse_wkt(kFrame);
  const DirectedOperands operands = make_operands(messy, frame, never);
  EXPECT_EQ(fault_of(operands), "");
  ASSERT_EQ(operands.p.size(), 1U);
  EXPECT_EQ(operands.p[0][0].size(), 4U);
  EXPECT_EQ(operands.direction_count, 4U);
  EXPECT_EQ(operands.p[0][0].extent.x, 4);
}

TEST(SignedOperands, HaveOneOrderOfDirections) {
  Cancellation never;
  const Region p = test::parse_wkt("POLYGON ((0.1 0.1, 0.3 0.1, 0.1 0.4, 0.1 0.1))");
  const Region q = test::parse_wkt("POLYGON ((5 5, 5.5 5, 5 5.75, 5 5))");
  const DirectedOperands operands = make_operands(p, q, never);
  EXPECT_EQ(operands.direction_count, 3U);
  EXPECT_EQ(operands.p[0][0].ranks, operands.q[0][0].ranks);
  EXPECT_EQ(operands.q[0][0].extent, (Point{Rational(1, 2), Rational(3, 4)}));
}

TEST(SignedOperands, CheckRejects) {
  const Region dart = test::parse_wkt(kDart);
  const Region frame = test::parse_wkt(kFrame);
  const auto fresh = [&] {
    Cancellation never;
    return make_operands(dart, frame, never);
  };
  DirectedOperands operands = fresh();
  std::swap(operands.p[0][0].vertices[0], operands.p[0][0].vertices[1]);
  EXPECT_NE(fault_of(operands), "");
  operands = fresh();
  operands.p[0][0].convex[3] = !operands.p[0][0].convex[3];
  EXPECT_NE(fault_of(operands), "");
  operands = fresh();
  std::swap(operands.p[0][0].ranks[0], operands.p[0][0].ranks[1]);
  EXPECT_NE(fault_of(operands), "");
}

TEST(SignedSegments, ConvexPairsMergeTheirEdges) {
  EXPECT_EQ(
      convolutions_of(test::parse_wkt(kSquare), test::parse_wkt("POLYGON ((0 0, 2 1, 0 3, 0 0))")),
      test::parse_wkt("POLYGON ((0 0, 4 0, 6 1, 6 5, 4 7, 0 7, 0 3, 0 0))"));
}

TEST(SignedSegments, ParallelEdgesCountOnce) { EXPECT_EQ(segments_of(kSquare, kSquare), 8U); }

TEST(SignedSegments, AreClosed) {
  for (const char* p : {kSquare, kDart, kFrame}) {
    for (const char* q : {kSquare, kDart, kFrame}) {
      Convolution convolution(p, q);
      EXPECT_TRUE(convolution.closes(convolution.segments)) << p << q;
    }
  }
  for (int i = 0; i < 500; ++i) {
    test::Random random(static_cast<std::uint64_t>(i));
    const test::Pair pair = test::random_pair(random);
    EXPECT_NO_THROW((void)convolutions_of(pair.p, pair.q)) << i << pair.kind;
  }
}

TEST(SignedSegments, LinkingRejectsEveryDamage) {
  Convolution convolution(kDart, kDart);
  ASSERT_TRUE(convolution.closes(convolution.segments));
  for (std::size_t i = 0; i < convolution.segments.size(); ++i) {
    std::vector<SignedSegment> damaged = convolution.segments;
    std::swap(damaged[i].from, damaged[i].to);
    EXPECT_FALSE(convolution.closes(damaged)) << "turned " << i;
    damaged = convolution.segments;
    damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(convolution.closes(damaged)) << "dropped " << i;
    damaged = convolution.segments;
    damaged.push_back(damaged[i]);
    EXPECT_FALSE(convolution.closes(damaged)) << "doubled " << i;
  }
}

TEST(SignedSegments, HolesCountOnlyIfTheOtherCanFitByWidths) {
  const std::size_t outer = segments_of("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))", kSquare);
  EXPECT_GT(segments_of(kFrame, kSquare), outer);  // 4 wide in a hole of 5
  EXPECT_GT(segments_of(kSquare, kFrame), outer);
  EXPECT_EQ(segments_of(kFrame, "POLYGON ((0 0, 5 0, 5 1, 0 1, 0 0))"), outer);
  EXPECT_EQ(segments_of(kFrame, kFrame), outer);
}

TEST(SignedSegments, LimitIsAnError) {
  Cancellation never;
  const Region dart = test::parse_wkt(kDart);
  const Region frame = test::parse_wkt(kFrame);
  const DirectedOperands operands = make_operands(dart, frame, never);
  const std::size_t count = signed_convolutions(operands, UINT64_MAX, never).vertex_count();
  EXPECT_NO_THROW((void)signed_convolutions(operands, count, never));
  for (const std::size_t most : {std::size_t{5}, count - 1}) {
    try {
      (void)signed_convolutions(operands, most, never);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
      EXPECT_EQ(error.limit()->value, most);
    }
  }
}

}  // namespace
}  // namespace minksum::signed_sum

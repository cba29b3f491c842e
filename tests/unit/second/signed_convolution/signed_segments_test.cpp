#include <gtest/gtest.h>

#include "minksum/error.hpp"
#include "minksum/testing.hpp"
#include "second/signed_convolution/operands.hpp"
#include "second/signed_convolution/segments.hpp"
#include "support/data.hpp"
#include "support/generators.hpp"

namespace minksum::signed_sum {
namespace {

struct Convolution {
  explicit Convolution(const char* p, const char* q)
      : Convolution(test::parse_wkt(p), test::parse_wkt(q)) {}
  Convolution(const Region& p, const Region& q)
      : operands(make_operands(p, q, never)),
        layers(make_layers(operands, never)),
        segments(signed_segments(operands, layers, SumSettings{}, never)) {}
  Convolution(const Convolution&) = delete;
  Convolution& operator=(const Convolution&) = delete;

  Cancellation never;
  IntegerOperands operands;
  std::vector<Layer> layers;
  std::vector<SignedSegment> segments;
};

bool are_closed(const std::vector<Layer>& layers, const std::vector<SignedSegment>& segments) {
  Cancellation never;
  return is_closed(layers, segments, never);
}

constexpr const char* kSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
constexpr const char* kDart = "POLYGON ((0 0, 6 0, 6 6, 4 2, 0 0))";
constexpr const char* kFrame = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 7 2, 7 7, 2 7, 2 2))";

TEST(SignedOperands, AreOrientedAndCleaned) {
  // The ring is clockwise, with a repeated vertex, and with straight vertices also at the start.
  const Region messy = test::parse_wkt("POLYGON ((2 0, 0 0, 0 4, 0 4, 2 4, 4 4, 4 0, 3 0, 2 0))");
  Cancellation never;
  const IntegerOperands operands = make_operands(messy, test::parse_wkt(kFrame), never);
  EXPECT_NO_THROW(check(operands));
  ASSERT_EQ(operands.p.size(), 1U);
  EXPECT_EQ(operands.p[0].outer.size(), 4U);
  EXPECT_EQ(operands.direction_count, 4U);
  EXPECT_EQ(operands.bits, 4U);  // 4 + 9 = 13
}

TEST(SignedOperands, HaveOneScale) {
  Cancellation never;
  const IntegerOperands operands =
      make_operands(test::parse_wkt("POLYGON ((0.1 0.1, 0.3 0.1, 0.1 0.4, 0.1 0.1))"),
                    test::parse_wkt("POLYGON ((5 5, 5.25 5, 5 7, 5 5))"), never);
  EXPECT_EQ(operands.scale, 20);
  EXPECT_EQ(operands.origin.x, 102);
  EXPECT_EQ(operands.bits, 6U);  // heights 6 and 40
}

TEST(SignedOperands, CheckRejects) {
  const auto fresh = [] {
    Cancellation never;
    return make_operands(test::parse_wkt(kDart), test::parse_wkt(kFrame), never);
  };
  IntegerOperands operands = fresh();
  std::swap(operands.p[0].outer.vertices[0], operands.p[0].outer.vertices[1]);
  EXPECT_THROW(check(operands), Error);
  operands = fresh();
  operands.p[0].outer.convex[3] = !operands.p[0].outer.convex[3];
  EXPECT_THROW(check(operands), Error);
  operands = fresh();
  std::swap(operands.p[0].outer.directions[0], operands.p[0].outer.directions[1]);
  EXPECT_THROW(check(operands), Error);
}

TEST(SignedSegments, ConvexPairsMergeTheirEdges) {
  const Convolution convolution(kSquare, "POLYGON ((0 0, 2 1, 0 3, 0 0))");
  EXPECT_EQ(convolution.segments.size(), 7U);
  for (const SignedSegment& segment : convolution.segments) EXPECT_EQ(segment.multiplicity, 1);
}

TEST(SignedSegments, ParallelEdgesCountOnce) {
  EXPECT_EQ(Convolution(kSquare, kSquare).segments.size(), 8U);
}

TEST(SignedSegments, AreClosed) {
  for (const char* p : {kSquare, kDart, kFrame}) {
    for (const char* q : {kSquare, kDart, kFrame}) {
      const Convolution convolution(p, q);
      EXPECT_TRUE(are_closed(convolution.layers, convolution.segments)) << p << q;
    }
  }
  for (int i = 0; i < 500; ++i) {
    test::Random random(static_cast<std::uint64_t>(i));
    const test::Pair pair = test::random_pair(random);
    const Convolution convolution(pair.p, pair.q);
    EXPECT_TRUE(are_closed(convolution.layers, convolution.segments)) << i << pair.kind;
  }
}

TEST(SignedSegments, ClosednessCheckRejectsEveryDamage) {
  const Convolution convolution(kDart, kDart);
  for (std::size_t i = 0; i < convolution.segments.size(); ++i) {
    std::vector<SignedSegment> damaged = convolution.segments;
    damaged[i].multiplicity = static_cast<std::int8_t>(-damaged[i].multiplicity);
    EXPECT_FALSE(are_closed(convolution.layers, damaged)) << "turned " << i;
    damaged = convolution.segments;
    damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(are_closed(convolution.layers, damaged)) << "dropped " << i;
    damaged = convolution.segments;
    damaged.push_back(damaged[i]);
    EXPECT_FALSE(are_closed(convolution.layers, damaged)) << "doubled " << i;
  }
}

TEST(SignedSegments, HolesCountOnlyIfTheOtherCanFitByWidths) {
  EXPECT_EQ(Convolution(kFrame, kSquare).layers.size(), 2U);  // 4 wide in a hole of 5
  EXPECT_EQ(Convolution(kSquare, kFrame).layers.size(), 2U);
  EXPECT_EQ(Convolution(kFrame, "POLYGON ((0 0, 5 0, 5 1, 0 1, 0 0))").layers.size(), 1U);
  EXPECT_EQ(Convolution(kFrame, kFrame).layers.size(), 1U);
}

TEST(SignedSegments, LimitIsAnError) {
  Cancellation never;
  const IntegerOperands operands =
      make_operands(test::parse_wkt(kDart), test::parse_wkt(kFrame), never);
  const std::vector<Layer> layers = make_layers(operands, never);
  SumSettings options;
  options.limits.max_segments = 5;
  try {
    (void)signed_segments(operands, layers, options, never);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
  }
}

}  // namespace
}  // namespace minksum::signed_sum

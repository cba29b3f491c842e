// Tests that a result may be one of its operands, by each method and each way to get tight places.
#include <gtest/gtest.h>

#include "minksum/minkowski_sum.hpp"
#include "minksum/testing.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::make_polygon;
using test::rectangle;

Region frame() {
  return make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}});
}
Region wedge() { return make_polygon({{0, 0}, {2, 0}, {1, 3}}); }
Geometry with_a_wall(Region region) { return {std::move(region), {{{20, 0}, {24, 3}}}, {{30, 1}}}; }

/// Expects the right sum if the result is either operand, or if both are one object.
template <class Set>
void expect_aliasing_is_allowed(const Set& p, const Set& q, const SumSettings& options) {
  Workspace workspace;
  Set expected;
  ASSERT_TRUE(minkowski_sum(p, q, options, workspace, expected).ok());
  ASSERT_FALSE(expected.empty());
  Set first = p;
  EXPECT_TRUE(minkowski_sum(first, q, options, workspace, first).ok());
  EXPECT_EQ(first, expected);
  Set second = q;
  EXPECT_TRUE(minkowski_sum(p, second, options, workspace, second).ok());
  EXPECT_EQ(second, expected);
  ASSERT_TRUE(minkowski_sum(p, p, options, workspace, expected).ok());
  Set both = p;
  EXPECT_TRUE(minkowski_sum(both, both, options, workspace, both).ok());
  EXPECT_EQ(both, expected);
}

TEST(Aliasing, AResultMayBeAnOperand) {
  for (const Method method : {Method::kReduced, Method::kSigned, Method::kFull}) {
    SCOPED_TRACE(static_cast<int>(method));
    SumSettings options;
    options.method = method;
    expect_aliasing_is_allowed(frame(), wedge(), options);
    expect_aliasing_is_allowed<Geometry>({frame(), {}, {}}, {wedge(), {}, {}}, options);
    if (method == Method::kFull) continue;  // this method takes no polylines
    expect_aliasing_is_allowed(with_a_wall(frame()), with_a_wall(wedge()), options);
  }
}

TEST(Aliasing, AResultMayBeAnOperandOfTheStages) {
  SumSettings options;
  options.check = true;  // then small operands go through the stages
  expect_aliasing_is_allowed(frame(), wedge(), options);
  expect_aliasing_is_allowed(with_a_wall(frame()), with_a_wall(wedge()), options);
}

TEST(Aliasing, AFailureEmptiesTheOperandThatIsTheResult) {
  Region bow_tie = make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  Workspace workspace;
  EXPECT_FALSE(minkowski_sum(bow_tie, wedge(), Options{}, workspace, bow_tie).ok());
  EXPECT_TRUE(bow_tie.empty());
}

}  // namespace
}  // namespace minksum

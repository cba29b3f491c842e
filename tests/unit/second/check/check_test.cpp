// Tests that check_sum accepts right results and catches planted errors.
#include "minksum/check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "reference/membership.hpp"
#include "second/check/placed_operand.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::make_polygon;
using test::make_region;
using test::rectangle;

// The sum of this frame and the bar, which passes through its hole, has a hole of 2 by 1.
Region frame() {
  return make_polygon({{0, 0}, {12, 0}, {12, 12}, {0, 12}}, {{{3, 3}, {3, 8}, {8, 8}, {8, 3}}});
}
Region bar() { return rectangle(0, 0, 3, 4); }

SumCheck check(const Region& result, const CheckOptions& options = {}) {
  return check_sum({result, {}, {}}, {frame(), {}, {}}, {bar(), {}, {}}, options);
}

TEST(CheckSum, FindsALostHoleThatIsSmall) {
  // The hole has a tenth by a tenth in a sum of 901 by 901, far from all of its other edges.
  const Region square = rectangle(0, 0, 1, 1);
  const Region lost = rectangle(0, 0, 901, 901);
  Region plate;
  plate.begin_polygon();
  plate.begin_ring();
  for (const auto& [x, y] : {std::pair{0, 0}, {900, 0}, {900, 900}, {0, 900}}) {
    plate.add_vertex(x, y);
  }
  plate.begin_ring();
  for (const auto& [x, y] : {std::pair{30, 30}, {30, 41}, {41, 41}, {41, 30}}) {
    plate.add_vertex(Rational(x, 10), Rational(y, 10));
  }
  CheckOptions options;
  options.proof.max_segments = 0;
  for (const bool swapped : {false, true}) {
    const Geometry p{swapped ? square : plate, {}, {}};
    const Geometry q{swapped ? plate : square, {}, {}};
    const SumCheck check = check_sum({lost, {}, {}}, p, q, options);
    EXPECT_EQ(check.proof, Proof::kNotTried);
    EXPECT_GT(check.disagreements, 0U);
    EXPECT_TRUE(check_sum(minkowski_sum(p, q), p, q, options).ok());
  }
}

TEST(Check, AcceptsASum) {
  const SumCheck found = check(minkowski_sum(frame(), bar()));
  EXPECT_TRUE(found.ok());
  EXPECT_EQ(found.proof, Proof::kHolds);
  EXPECT_EQ(found.result_area, *found.sum_area);
  EXPECT_FALSE(found.missing->at.has_value());
  EXPECT_GT(found.points, 1000U);
}

struct Planted {
  const char* what;
  Region result;
};

std::vector<Planted> planted_errors() {
  const std::vector<test::Outline> right{{{0, 0}, {15, 0}, {15, 16}, {0, 16}},
                                         {{6, 7}, {6, 8}, {8, 8}, {8, 7}}};
  const auto with = [&](const std::function<void(std::vector<test::Outline>&)>& change) {
    std::vector<test::Outline> rings = right;
    change(rings);
    return make_region({rings});
  };
  EXPECT_EQ(make_region({right}), minkowski_sum(frame(), bar()));
  return {
      {"a lost hole", with([](auto& r) { r.pop_back(); })},
      {"a shifted vertex", with([](auto& r) { r[0][2].y = 17; })},
      {"a shifted vertex of the hole", with([](auto& r) { r[1][2].x = 9; })},
      {"a spurious hole", with([](auto& r) { r.push_back({{1, 1}, {1, 2}, {2, 1}}); })},
      {"a spurious part", make_region({right, {{{20, 0}, {21, 0}, {20, 1}}}})},
      {"a filled outline only", make_region({{right[0]}})},
      {"nothing at all", Region()},
      {"an operand instead of the sum", frame()},
  };
}

TEST(Check, RefutesPlantedErrors) {
  for (const Planted& planted : planted_errors()) {
    const SumCheck found = check(planted.result);
    EXPECT_FALSE(found.ok()) << planted.what;
    EXPECT_EQ(found.proof, Proof::kRefuted) << planted.what;
    EXPECT_TRUE(found.missing->at.has_value() || found.surplus->at.has_value()) << planted.what;
  }
}

// The points alone find the errors and their places, so the proof is not needed.
TEST(Check, PointsFindPlantedErrorsByThemselves) {
  CheckOptions options;
  options.proof.max_segments = 1;
  for (const Planted& planted : planted_errors()) {
    const SumCheck found = check(planted.result, options);
    EXPECT_EQ(found.proof, Proof::kNotTried) << planted.what;
    ASSERT_GT(found.disagreements, 0U) << planted.what;
    const Disagreement& one = found.examples.at(0);
    const bool in_sum = reference::contains_sum(frame(), bar(), reference::to_pt(one.at));
    EXPECT_NE(in_sum, one.in_result) << planted.what;
  }
}

TEST(Check, NamesInvalidResults) {
  const Region bow_tie = make_polygon({{0, 0}, {15, 16}, {15, 0}, {0, 16}});
  EXPECT_FALSE(check(bow_tie).faults.empty());
  // Two rings touch twice, so the region is valid as an operand, but not by the OGC's rules.
  const Region cut = make_polygon({{0, 0}, {15, 0}, {15, 16}, {0, 16}},
                                  {{{0, 8}, {7, 9}, {15, 8}, {7, 7}}});
  EXPECT_FALSE(check(cut).faults.empty());
}

TEST(Check, AllowsWhatIsAskedFor) {
  const Region near = make_polygon({{0, 0}, {15, 0}, {15, 17}, {0, 16}},
                                   {{{6, 7}, {6, 8}, {8, 8}, {8, 7}}});
  CheckOptions options;
  options.within = Rational(1);
  EXPECT_TRUE(check(near, options).ok());
  options.within = Rational(999, 1000);
  const SumCheck found = check(near, options);
  EXPECT_FALSE(found.ok());
  EXPECT_EQ(found.proof, Proof::kRefuted);
  options.within = Rational(-1);
  EXPECT_THROW((void)check(near, options), Error);
}

// A hole that is no wider than the tolerance may be lost, because its points are near the sum.
TEST(Check, ALostHoleCountsByItsWidth) {
  const Region filled = rectangle(0, 0, 15, 16);
  CheckOptions options;
  options.within = Rational(1, 2);
  EXPECT_TRUE(check(filled, options).ok());
  options.within = Rational(49, 100);
  EXPECT_FALSE(check(filled, options).ok());
}

TEST(Check, PlacementsAgreeWithTheReference) {
  test::Random random(20);
  for (int i = 0; i < 60; ++i) {
    const Region p = test::random_region(random);
    const Region q = test::random_region(random);
    Cancellation never;
    const checking::PlacedOperand placement({p, {}, {}}, {q, {}, {}}, never);
    for (int k = 0; k < 40; ++k) {
      // Of these halves, half of the points are on lines of edges, where touching decides.
      const Point x{Rational(random.between(-4, 100), 2), Rational(random.between(-4, 100), 2)};
      EXPECT_EQ(placement.in_sum(x), reference::contains_sum(p, q, reference::to_pt(x)))
          << test::to_text(p) << ' ' << test::to_text(q) << ' ' << x.x << ' ' << x.y;
    }
  }
}

TEST(Check, PlacementsOfThinParts) {
  const Geometry cross{{}, {{{0, 0}, {4, 0}}, {{2, -2}, {2, 2}}}, {{9, 9}}};
  const Geometry square{rectangle(0, 0, 1, 1), {}, {}};
  Cancellation never;
  const checking::PlacedOperand placement(cross, square, never);
  const auto in_sum = [&](int x2, int y2) {
    return placement.in_sum({Rational(x2, 2), Rational(y2, 2)});
  };
  EXPECT_TRUE(in_sum(0, 0));
  EXPECT_TRUE(in_sum(10, 2));
  EXPECT_FALSE(in_sum(11, 2));
  EXPECT_TRUE(in_sum(5, -3));
  EXPECT_FALSE(in_sum(3, -3));
  EXPECT_TRUE(in_sum(18, 18));
  EXPECT_TRUE(in_sum(19, 19));
  EXPECT_FALSE(in_sum(21, 19));
  const checking::PlacedOperand lines(cross, cross, never);
  EXPECT_TRUE(lines.in_sum({Rational(18), Rational(18)}));   // the point twice
  EXPECT_TRUE(lines.in_sum({Rational(5), Rational(1)}));     // crossing segments
  EXPECT_TRUE(lines.in_sum({Rational(8), Rational(0)}));     // ends
  EXPECT_FALSE(lines.in_sum({Rational(9), Rational(0)}));
}

TEST(Check, HugeAndTinyNumbers) {
  const Rational huge(1.7e308);
  const Rational tiny(5e-324);
  for (const Rational& unit : {huge, tiny}) {
    const Region triangle = test::scaled(make_polygon({{0, 0}, {1, 0}, {0, 1}}), unit);
    const Region sum = minkowski_sum(triangle, triangle);
    const Geometry operand{triangle, {}, {}};
    EXPECT_TRUE(check_sum({sum, {}, {}}, operand, operand).ok());
    EXPECT_FALSE(check_sum({triangle, {}, {}}, operand, operand).ok());
  }
}

}  // namespace
}  // namespace minksum

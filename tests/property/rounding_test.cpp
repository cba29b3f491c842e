// Tests that rounded regions are valid, on the target, close to the exact one, and on its right
// side.
#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"
#include "property/sums.hpp"
#include "reference/boundary_distance.hpp"
#include "reference/brute_force_overlay.hpp"
#include "reference/exact.hpp"
#include "reference/validity.hpp"
#include "support/geos_validity.hpp"
#include "support/rounding_options.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

Rational power_of_ten(int exponent) { return Rational(Decimal{1, exponent}); }

/// Returns whether all coordinates are doubles, or decimals with so many digits.
bool on_target(const Region& region, std::optional<int> decimals) {
  const auto is = [&](const Rational& value, double nearest) {
    return decimals ? (value * power_of_ten(*decimals)).is_integer() : value == Rational(nearest);
  };
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    if (!is(region.exact_x(v), region.x(v)) || !is(region.exact_y(v), region.y(v))) return false;
  }
  return true;
}

/// Returns the fault that GEOS finds. Decimals are scaled to integers, because GEOS has only
/// doubles.
std::string fault_by_geos(const Region& region, std::optional<int> decimals) {
  return geos_fault(decimals ? scaled(region, power_of_ten(*decimals)) : region);
}

/// Counts what happened, for the log of a long run.
struct Tally {
  std::uint64_t rounded = 0;
  std::uint64_t exact = 0;
  std::uint64_t snapped = 0;
  std::uint64_t topology_lost = 0;
};

class Checker {
 public:
  Checker(const Region& exact, RoundOptions options) : exact_(exact), options_(options) {
    rounded_ = round(exact, options, report_);
  }

  void check_all(Tally& tally) const {
    ++tally.rounded;
    tally.exact += report_.exact ? 1 : 0;
    tally.snapped += report_.snapped ? 1 : 0;
    tally.topology_lost += report_.topology_kept ? 0 : 1;
    EXPECT_TRUE(on_target(rounded_, options_.decimals));
    EXPECT_EQ(fault_by_geos(rounded_, options_.decimals), "");
    EXPECT_LE(report_.largest_move, report_.bound);
    if (report_.exact) {
      EXPECT_EQ(rounded_, exact_);
      EXPECT_EQ(report_.largest_move, 0);
    }
    if (options_.side == RoundingSide::kOutside) {
      EXPECT_TRUE(contains(rounded_, exact_));
    }
    if (options_.side == RoundingSide::kInside) {
      EXPECT_TRUE(contains(exact_, rounded_));
    }
  }

  /// Checks the same and more, by slow means that share nothing with the library.
  void check_by_reference() const {
    EXPECT_EQ(reference::validity_fault(rounded_), "");
    EXPECT_EQ(reference::canonical_fault(rounded_), "");
    EXPECT_FALSE(is_far(rounded_));
    const auto lost = reference::brute_force_boolean(
        exact_, rounded_, [](bool exact, bool rounded) { return exact && !rounded; });
    const auto won = reference::brute_force_boolean(
        exact_, rounded_, [](bool exact, bool rounded) { return rounded && !exact; });
    if (options_.side == RoundingSide::kOutside) {
      EXPECT_TRUE(lost.empty());
    }
    if (options_.side == RoundingSide::kInside) {
      EXPECT_TRUE(won.empty());
    }
    EXPECT_FALSE(is_far(lost));
    EXPECT_FALSE(is_far(won));
  }

  [[nodiscard]] std::string text() const {
    return std::string(to_string(options_.side)) + ", decimals " +
           (options_.decimals ? std::to_string(*options_.decimals) : "none") + "\nexact " +
           to_text(exact_) + "\nrounded " + to_text(rounded_);
  }

 private:
  [[nodiscard]] bool is_far(const Region& region) const {
    return reference::farther_than(report_.largest_move, {region, {}, {}}, {exact_, {}, {}});
  }

  const Region& exact_;
  RoundOptions options_;
  RoundingReport report_;
  Region rounded_;
};

/// Returns a sum of two small operands, at a scale that makes its features larger or smaller than
/// the steps of rounding.
Region random_sum(Random& random) {
  const Pair pair = random_pair(random);
  const Rational turned_scale(random.between(1, 60), random.between(1, 60));
  return scaled(minkowski_sum(pair.p, pair.q), turned_scale);
}

void round_every_way(const Region& exact, bool by_reference, Tally& tally) {
  for (const RoundingSide side : kRoundingSides) {
    for (const std::optional<int> decimals :
         {std::optional<int>{}, std::optional<int>{3}, std::optional<int>{0}}) {
      const Checker checker(exact, rounding(decimals, side));
      SCOPED_TRACE(checker.text());
      checker.check_all(tally);
      if (by_reference) checker.check_by_reference();
    }
  }
}

TEST(Rounding, ItsJudgesCanReject) {
  const Region square = rectangle(0, 0, 4, 4);
  EXPECT_FALSE(reference::farther_than(0.5, {square, {}, {}}, {rectangle(0, 0, 4, 4), {}, {}}));
  EXPECT_TRUE(reference::farther_than(0.9, {rectangle(1, 1, 3, 3), {}, {}},
                                      {rectangle(0, 0, 4, 4), {}, {}}));
  EXPECT_FALSE(on_target(scaled(square, Rational(1, 3)), std::nullopt));
  EXPECT_FALSE(on_target(scaled(square, Rational(1, 100)), 1));
  EXPECT_TRUE(on_target(scaled(square, Rational(1, 100)), 2));
  EXPECT_EQ(geos_fault(square), "");
  if (!geos_available()) return;
  EXPECT_NE(geos_fault(make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}})), "");
  // The hole reaches from wall to wall.
  EXPECT_NE(geos_fault(make_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{0, 2}, {2, 1}, {4, 2}}})),
            "");
}

TEST(Rounding, RandomSums) {
  constexpr int kDefaultSums = 1500;
  constexpr std::uint64_t kReferenceEvery = 50;
  const std::uint64_t first = seed_from_environment(1);
  const auto count = static_cast<std::uint64_t>(count_from_environment(kDefaultSums));
  if (!geos_available()) std::cout << "GEOS was not found: its opinion is not asked\n";
  Tally tally;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    round_every_way(random_sum(random), seed % kReferenceEvery == 0, tally);
  }
  std::cout << tally.rounded << " rounded, " << tally.exact << " exact, " << tally.snapped
            << " snapped, " << tally.topology_lost << " with another topology\n";
}

}  // namespace

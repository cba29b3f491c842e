// Tests sums of random degenerate pairs, with random settings, against the signed method and brute
// force, and tight places against brute force. MINKSUM_PAIRS is the number of pairs, MINKSUM_SEED
// the first seed.
#include "support/degenerate_pairs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <exception>
#include <iostream>
#include <map>

#include "minksum/round.hpp"
#include "minksum/testing.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/geometry_laws.hpp"
#include "support/messes.hpp"
#include "support/rounding_options.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr int kDefaultPairs = 600;
constexpr int kMaxFailures = 5;
// Pairs with more work for brute force are left out.
constexpr std::size_t kMaxWork = 140;
// The slow laws are tested for some pairs only.
constexpr std::uint64_t kAllLawsEvery = 16;

SumSettings random_setting(Random& random) {
  constexpr std::array kRules = {FillRule::kAutomatic, FillRule::kAutomatic, FillRule::kEvenOdd,
                                 FillRule::kNonZero,   FillRule::kPositive,  FillRule::kNegative};
  // Slow settings, such as the last one, are rare.
  constexpr std::array kArithmetics = {Arithmetic::kAutomatic, Arithmetic::kAutomatic,
                                       Arithmetic::kAutomatic, Arithmetic::kMedium,
                                       Arithmetic::kMedium,    Arithmetic::kWide,
                                       Arithmetic::kWide,      Arithmetic::kArbitrary};
  SumSettings setting;
  setting.fill = kRules[static_cast<std::size_t>(random.below(kRules.size()))];
  setting.regularize = random.one_in(5);
  setting.arithmetic = kArithmetics[static_cast<std::size_t>(random.below(kArithmetics.size()))];
  setting.cover = !random.one_in(4);
  setting.filter = !random.one_in(8);
  setting.check = random.one_in(12);
  if (random.one_in(2)) setting.grid = random.between(1, 40);
  return setting;
}

struct Tally {
  std::map<std::string, int> kinds;
  int with_area = 0;
  int with_thin_parts = 0;
  int with_tight_points = 0;
  int with_tight_lines = 0;
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
  for (const auto& [kind, count] : tally.kinds) out << kind << ": " << count << ", ";
  return out << "sums with area: " << tally.with_area << ", thin parts: " << tally.with_thin_parts
             << ", tight points: " << tally.with_tight_points
             << ", tight lines: " << tally.with_tight_lines;
}

SumCase random_case(Random& random, Tally& tally) {
  for (;;) {
    const DegeneratePair pair = random_degenerate_pair(random);
    const SumCase sum_case{pair.p, pair.q, random_setting(random)};
    if (brute_force_work(sum_case) > kMaxWork) continue;
    ++tally.kinds[pair.kind];
    return sum_case;
  }
}

void count(const SumCase& sum_case, Tally& tally) {
  SumSettings options = sum_case.setting;
  options.check = false;
  options.tight = true;
  const auto [sum, tight, statistics, trace] = detailed_sum(sum_case.p, sum_case.q, options);
  tally.with_area += sum.region.empty() ? 0 : 1;
  tally.with_thin_parts += sum.has_thin_parts() ? 1 : 0;
  tally.with_tight_points += tight.points.empty() ? 0 : 1;
  tally.with_tight_lines += tight.polylines.empty() ? 0 : 1;
}

std::string first_broken_law(const SumCase& sum_case, bool all) {
  const SumSettings& setting = sum_case.setting;
  for (const Geometry* geometry : {&sum_case.p, &sum_case.q}) {
    std::string fault = broken_resolve(*geometry, setting.fill, setting.regularize);
    if (!fault.empty()) return fault;
  }
  std::string fault = broken_sum(sum_case);
  if (fault.empty()) fault = broken_tight(sum_case);
  if (!fault.empty() || !all) return fault;
  const Geometry sum = minkowski_sum(sum_case.p, sum_case.q, setting);
  fault = broken_form(sum);
  if (fault.empty()) fault = broken_check(sum_case, sum);
  if (fault.empty()) fault = broken_rounding(scaled(sum, Rational(1, 7)));
  return fault;
}

TEST(DegeneratePairs, ObeyAllLaws) {
  const std::uint64_t first = seed_from_environment(1);
  const auto pairs = static_cast<std::uint64_t>(count_from_environment(kDefaultPairs));
  Tally tally;
  int failures = 0;
  std::uint64_t done = 0;
  for (; done < pairs && failures < kMaxFailures; ++done) {
    const std::uint64_t seed = first + done;
    Random random(seed);
    const SumCase sum_case = random_case(random, tally);
    const auto map = random_scaling(random);
    std::string fault;
    try {
      fault = first_broken_law(sum_case, seed % kAllLawsEvery == 0);
      if (fault.empty() && seed % 4 == 0) fault = broken_scaling(sum_case, map);
      count(sum_case, tally);
    } catch (const std::exception& error) {
      fault = error.what();
    }
    EXPECT_EQ(fault, "") << "seed " << seed << ", " << note(sum_case);
    failures += fault.empty() ? 0 : 1;
    if ((done + 1) % 5000 == 0) std::cout << done + 1 << " pairs done" << std::endl;
  }
  std::cout << done << " pairs from seed " << first << "; " << tally << '\n';
}

// The laws themselves must find planted errors.

TEST(GeometryLaws, RoundingThatIsWrongIsFound) {
  const Geometry exact{scaled(rectangle(1, 1, 11, 11), Rational(1, 10)), {}, {}};
  RoundOptions options;
  options.decimals = 0;
  RoundingReport report;
  const auto fault = [&](const Geometry& rounded) {
    return broken_rounding(exact, options, report, rounded);
  };
  const Geometry right = test::round(exact, options, report);
  EXPECT_EQ(fault(right), "");
  EXPECT_NE(fault(exact), "");
  EXPECT_NE(fault({make_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), {}, {}}), "");
  EXPECT_NE(fault({right.region, {}, {{0, 0}}}), "");
  options.side = RoundingSide::kOutside;
  EXPECT_NE(fault(right), "");
  EXPECT_EQ(fault({rectangle(0, 0, 2, 2), {}, {}}), "");
  options.side = RoundingSide::kInside;
  EXPECT_NE(fault(right), "");
  EXPECT_EQ(fault({}), "");
  report.largest_move = 2 * report.bound + 1;
  EXPECT_NE(fault({}), "");
}

TEST(GeometryLaws, ResultsThatAreWrongAreFound) {
  const Geometry square{rectangle(0, 0, 2, 2), {}, {}};
  EXPECT_EQ(broken_form(square), "");
  EXPECT_NE(broken_form({square.region, {}, {{1, 1}}}), "");
  EXPECT_NE(broken_form({scaled(square.region, -1), {}, {}}), "");
  const SumCase twice{square, square, {}};
  EXPECT_EQ(broken_check(twice, minkowski_sum(square, square)), "");
  EXPECT_NE(broken_check(twice, square), "");
}

}  // namespace

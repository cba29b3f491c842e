// Tests that settings change how a sum is computed, but no byte of the result.
#include "support/settings.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/transform.hpp"
#include "property/provenance.hpp"
#include "property/sums.hpp"
#include "reference/validity.hpp"
#include "support/data.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

void expect_same_everywhere(const Region& p, const Region& q, const std::string& about) {
  const Region expected = minkowski_sum(p, q);
  const std::string text = to_text(expected);
  for (Setting& setting : settings()) {
    const DetailedSum found = detailed_sum(p, q, setting.options);
    const Region& result = found.sum.region;
    const Statistics& statistics = found.statistics;
    EXPECT_EQ(result, expected) << setting.name << ", " << about;
    EXPECT_EQ(to_text(result), text) << setting.name << ", " << about;
    if (setting.options.method != Method::kSigned) {  // the signed method gives no origins
      EXPECT_EQ(provenance_fault(p, q, result), "") << setting.name << ", " << about;
    }
    // A rung that is too narrow for the operands is skipped.
    EXPECT_GE(statistics.arithmetic, setting.options.arithmetic) << setting.name << ", " << about;
    if (!setting.options.filter) {
      EXPECT_EQ(statistics.by_filter, 0U) << setting.name;
    }
  }
}

TEST(Settings, SmallRandomPairs) {
  for (std::uint64_t seed = 1; seed <= 250 && !HasFailure(); ++seed) {
    Random random(seed * 104729);
    const Pair pair = random_pair(random);
    expect_same_everywhere(pair.p, pair.q, note(seed * 104729, pair));
  }
}

TEST(Settings, LargerShapes) {
  Random random(11);
  const Region star_a = spiky_star(random, 16, 100000);
  const Region star_b = spiky_star(random, 16, 100000);
  expect_same_everywhere(star_a, star_b, "spiky stars");
  expect_same_everywhere(star_a, star_a, "a spiky star and itself");
  expect_same_everywhere(spiral(5), comb(6, 1, 5), "spiral and comb");
  expect_same_everywhere(comb(8, 2, 11), turned(comb(8, 2, 11)), "two combs");
  expect_same_everywhere(spiral(4), rectangle(0, 0, 1, 1), "a spiral closed by a square");
  expect_same_everywhere(round_polygon(60, 5000), round_polygon(45, 700), "round");
  expect_same_everywhere(random_two_opt(random, 60, 500), random_two_opt(random, 50, 300), "2-opt");
  expect_same_everywhere(random_with_holes(random, 60, 12), rectangle(0, 0, 2, 1), "holes");
  expect_same_everywhere(random_cells(random, 9, 9, true, false),
                         random_cells(random, 5, 5, true, false), "cells");
}

TEST(Settings, SizesFarApart) {
  for (std::uint64_t seed = 1; seed <= 12 && !HasFailure(); ++seed) {
    Random random(seed * 7927);
    const std::int64_t size = std::int64_t{1} << random.between(28, 60);
    const Region small = spiky_star(random, 12, 60);
    Region huge = transform(random_two_opt(random, 8, 40), Affine::scaling(size));
    if (random.one_in(2)) huge = subtract(huge, transform(small, Affine{1, 0, 70, 0, 1, 30}));
    expect_same_everywhere(huge, small, "seed " + std::to_string(seed));
  }
}

// Returns a region that is large enough for the cover to matter, with holes, slits, parts and
// touching rings.
Region medium_region(Random& random) {
  switch (random.below(6)) {
    case 0:
      return random_cells(random, random.between(6, 12), random.between(6, 12), true, false);
    case 1:
      return random_cells(random, random.between(5, 9), random.between(5, 9), false, false);
    case 2:
      return random_with_holes(random, 60, 10);
    case 3:
      return random_two_opt(random, random.between(20, 60), 100);
    case 4:
      return spiral(random.between(2, 6));
    default:
      return random_star_shaped(random, random.between(20, 60), 64);
  }
}

TEST(Settings, MediumPairsByTwoMethods) {
  std::size_t holes = 0;
  for (std::uint64_t seed = 1; seed <= 100 && !HasFailure(); ++seed) {
    Random random(seed * 15485863);
    const Region p = medium_region(random);
    static constexpr int kDivisors[] = {1, 2, 3, 4, 5, 8, 10, 16, 20, 32};
    const Region q = scaled(medium_region(random), Rational(1, kDivisors[random.below(10)]));
    const Region sum = minkowski_sum(p, q);
    EXPECT_EQ(sum, sum_by(Method::kSigned, p, q)) << note(seed, p, q);
    EXPECT_EQ(provenance_fault(p, q, sum), "") << note(seed, p, q);
    for (const int grid : {5, 24, 100}) {
      SumSettings options;
      options.grid = grid;
      options.check = grid == 24;
      EXPECT_EQ(sum, minkowski_sum(p, q, options)) << "grid " << grid << ' ' << note(seed, p, q);
    }
    if (seed % 10 == 0) {
      EXPECT_EQ(reference::canonical_fault(sum), "") << note(seed, p, q);
    }
    holes += sum.hole_count();
  }
  EXPECT_GT(holes, 100U);
}

TEST(Settings, WorkspaceAndRepetition) {
  Workspace workspace;
  Region result;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    const Outcome outcome = minkowski_sum(pair.p, pair.q, Options{}, workspace, result);
    ASSERT_TRUE(outcome.ok()) << outcome.error->what() << note(seed, pair);
    EXPECT_EQ(result, minkowski_sum(pair.p, pair.q)) << note(seed, pair);
  }
}

TEST(Settings, RealShapes) {
  const auto data = data_path();
  if (!data) GTEST_SKIP() << "no folder of shapes";
  const auto read = [&data](const char* name) { return read_wkt(*data / name); };
  expect_same_everywhere(read("paper/bird.wkt"), read("nesting/albano_3.wkt"), "bird, albano_3");
  expect_same_everywhere(read("cgal/rooms_part1.wkt"), read("cgal/rooms_part2.wkt"), "rooms");
  expect_same_everywhere(read("cgal/pwh1.wkt"), read("cgal/pwh2.wkt"), "pwh1, pwh2");
}

}  // namespace

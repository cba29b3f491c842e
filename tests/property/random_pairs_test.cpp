// Tests all methods against brute force on many small random pairs. MINKSUM_PAIRS is the number of
// pairs, MINKSUM_SEED the first seed. The seed that a failure prints, with MINKSUM_PAIRS=1, repeats
// it.
#include <gtest/gtest.h>

#include <exception>
#include <iostream>
#include <vector>

#include "property/provenance.hpp"
#include "property/sums.hpp"
#include "reference/brute_force.hpp"
#include "reference/validity.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr int kDefaultPairs = 10000;
constexpr std::uint64_t kFirstSeed = 1;
constexpr std::size_t kMaxFailures = 5;

// Counts the kinds of pairs, because a sample without holes or touching rings would prove little.
struct Tally {
  int operands_with_holes = 0;
  int operands_in_parts = 0;
  int sums_with_holes = 0;
  int sums_in_parts = 0;

  void count(const Pair& pair, const Region& sum) {
    operands_with_holes += pair.p.hole_count() + pair.q.hole_count() > 0 ? 1 : 0;
    operands_in_parts += pair.p.polygon_count() + pair.q.polygon_count() > 2 ? 1 : 0;
    sums_with_holes += sum.hole_count() > 0 ? 1 : 0;
    sums_in_parts += sum.polygon_count() > 1 ? 1 : 0;
  }
};

void compare(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const Pair pair = random_pair(random);
  const Region truth = reference::brute_force_sum(pair.p, pair.q);
  tally.count(pair, truth);
  const Region reduced = minkowski_sum(pair.p, pair.q);
  EXPECT_EQ(to_text(reduced), to_text(truth)) << "reduced; " << note(seed, pair);
  EXPECT_EQ(provenance_fault(pair.p, pair.q, reduced), "") << note(seed, pair);
  const Region staged = sum_by_stages(pair.p, pair.q);
  EXPECT_EQ(to_text(staged), to_text(truth)) << "by stages; " << note(seed, pair);
  EXPECT_EQ(provenance_fault(pair.p, pair.q, staged), "") << note(seed, pair);
  const Region by_winding = sum_by(Method::kSigned, pair.p, pair.q);
  EXPECT_EQ(to_text(by_winding), to_text(truth)) << "signed; " << note(seed, pair);
  if (seed % 4 == 0) {
    const Region full = sum_by(Method::kFull, pair.p, pair.q);
    EXPECT_EQ(to_text(full), to_text(truth)) << "full; " << note(seed, pair);
  }
  if (seed % 16 == 0) {
    EXPECT_EQ(reference::canonical_fault(reduced), "") << note(seed, pair);
  }
}

int failures_so_far() {
  return ::testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

TEST(RandomPairs, ReducedIsSignedIsBruteForce) {
  const std::uint64_t first = seed_from_environment(kFirstSeed);
  const auto count = static_cast<std::uint64_t>(count_from_environment(kDefaultPairs));
  std::uint64_t done = 0;
  std::vector<std::uint64_t> failed;
  Tally tally;
  for (; done < count && failed.size() < kMaxFailures; ++done) {
    const std::uint64_t seed = first + done;
    const int before = failures_so_far();
    try {
      compare(seed, tally);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "; seed " << seed;
    }
    if (failures_so_far() > before) failed.push_back(seed);
  }
  for (const std::uint64_t seed : failed) std::cout << "failed: seed " << seed << '\n';
  std::cout << done << " pairs from seed " << first << "; with holes: " << tally.operands_with_holes
            << ", in parts: " << tally.operands_in_parts
            << "; sums with holes: " << tally.sums_with_holes
            << ", in parts: " << tally.sums_in_parts << '\n';
}

// Doubles hold no digit of the smaller operand, so the order of events on a segment is exact work.
TEST(RandomPairs, OperandsOfSizesThatDoublesCannotAdd) {
  const Rational factor = Rational::parse("1e200").value();
  const auto count = static_cast<std::uint64_t>(count_from_environment(kDefaultPairs)) / 100;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    Random random(seed);
    Pair pair = random_pair(random);
    Region& larger = random.one_in(2) ? pair.p : pair.q;
    larger = scaled(larger, factor);
    const Region sum = minkowski_sum(pair.p, pair.q);
    ASSERT_EQ(to_text(sum), to_text(sum_by(Method::kSigned, pair.p, pair.q))) << note(seed, pair);
    ASSERT_EQ(to_text(sum), to_text(reference::brute_force_sum(pair.p, pair.q)))
        << note(seed, pair);
  }
}

}  // namespace

// Tests that repeated calls with a workspace do not allocate, do not disturb each other, and stop.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <random>
#include <thread>

#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/testing.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

namespace {
std::atomic<std::size_t> allocations{0};
}  // namespace

// Counts every allocation of this program. The operators are not inlined, because the compiler
// would warn of malloc and delete together.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size != 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using namespace minksum;
using namespace minksum::test;

/// Returns a ragged ring around a hole, each of `n` vertices with coordinates of about six digits.
Region ragged_frame(int n, double radius, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Region region;
  region.begin_polygon();
  for (const double scale : {1.0, 0.5}) {
    region.begin_ring();
    for (int i = 0; i < n; ++i) {
      const double r = scale * radius * (0.8 + 0.2 * static_cast<double>(random() % 997) / 997);
      const double angle = 2 * 3.141592653589793 * i / n;
      region.add_vertex(static_cast<std::int64_t>(r * std::cos(angle)),
                        static_cast<std::int64_t>(r * std::sin(angle)));
    }
  }
  return region;
}

TEST(Workspace, RepeatedCallsDoNotAllocate) {
  const Region p = ragged_frame(150, 400000, 1);
  const Region q = ragged_frame(60, 90000, 2);
  Workspace workspace;
  Region sum;
  const SumSettings options;
  ASSERT_TRUE(minkowski_sum(p, q, options, workspace, sum).ok());
  const Region first = sum;
  EXPECT_GT(sum.hole_count(), 0U);
  // Buffers are swapped as they pass through the stages, so a second call may still grow some.
  ASSERT_TRUE(minkowski_sum(p, q, options, workspace, sum).ok());
  const std::size_t before = allocations;
  const Outcome outcome = minkowski_sum(p, q, options, workspace, sum);
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_TRUE(outcome.ok());
  EXPECT_EQ(sum, first);
}

/// Returns how often a third call with the same workspace allocates.
template <class Operand>
std::size_t allocations_of_a_repeated_call(const Operand& p, const Operand& q) {
  Workspace workspace;
  Region sum;
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(minkowski_sum(p, q, Options{}, workspace, sum).ok());
  }
  const std::size_t before = allocations;
  const Outcome outcome = minkowski_sum(p, q, Options{}, workspace, sum);
  const std::size_t count = allocations - before;
  EXPECT_TRUE(outcome.ok());
  return count;
}

TEST(Workspace, RepeatedCallsWithLongRingsDoNotAllocate) {
  EXPECT_EQ(
      allocations_of_a_repeated_call(ragged_frame(1200, 400000, 1), ragged_frame(5, 90000, 2)), 0U);
}

TEST(Workspace, RepeatedCallsWithPreparedOperandsDoNotAllocate) {
  const PreparedRegion p(ragged_frame(150, 400000, 1));
  const PreparedRegion q(ragged_frame(60, 90000, 2));
  EXPECT_EQ(allocations_of_a_repeated_call(p, q), 0U);
}

TEST(Workspace, RepeatedCallsWithValidGeometriesDoNotAllocate) {
  const Geometry p{ragged_frame(150, 400000, 1), {}, {}};
  const Geometry q{ragged_frame(60, 90000, 2), {}, {}};
  Workspace workspace;
  Geometry sum;
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(minkowski_sum(p, q, Options{}, workspace, sum).ok());
  const std::size_t before = allocations;
  const Outcome outcome = minkowski_sum(p, q, Options{}, workspace, sum);
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_TRUE(outcome.ok());
  EXPECT_EQ(sum.region, minkowski_sum(p.region, q.region));
  EXPECT_TRUE(sum.region.has_origins());
}

TEST(Workspace, HoldsNothingOfOneCallForTheNext) {
  const Region big = ragged_frame(100, 400000, 3);
  const Region small = ragged_frame(20, 30000, 4);
  const Region square = rectangle(0, 0, 7, 7);
  Workspace workspace;
  Region sum;
  const std::vector<std::pair<const Region*, const Region*>> calls{
      {&big, &small}, {&square, &square}, {&small, &big}, {&square, &big}, {&big, &small}};
  for (const Arithmetic arithmetic : {Arithmetic::kAutomatic, Arithmetic::kArbitrary}) {
    for (const auto& [p, q] : calls) {
      SumSettings options;
      options.arithmetic = arithmetic;
      ASSERT_TRUE(minkowski_sum(*p, *q, options, workspace, sum).ok());
      ASSERT_EQ(sum, minkowski_sum(*p, *q));
    }
  }
}

TEST(Workspace, AFailureLeavesAnEmptyResultAndAUsableWorkspace) {
  const Region square = rectangle(0, 0, 7, 7);
  const Region bow_tie = make_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  Workspace workspace;
  Region sum = square;
  const Outcome outcome = minkowski_sum(square, bow_tie, Options{}, workspace, sum);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->code(), ErrorCode::kBadInput);
  EXPECT_EQ(outcome.error->culprit().operand, 1);
  EXPECT_EQ(outcome.error->culprit().polygon, 0U);
  EXPECT_EQ(outcome.error->culprit().ring, 0U);
  EXPECT_TRUE(sum.empty());
  EXPECT_TRUE(minkowski_sum(square, square, Options{}, workspace, sum).ok());
  EXPECT_EQ(sum, rectangle(0, 0, 14, 14));
}

TEST(Threads, SumsSideBySideAreTheSame) {
  MINKSUM_NEEDS_THREADS();
  const Region p = ragged_frame(120, 400000, 5);
  const Region q = ragged_frame(40, 60000, 6);
  const Region expected = minkowski_sum(p, q);
  std::atomic<int> equal{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 10; ++i) equal += minkowski_sum(p, q) == expected ? 1 : 0;
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(equal, 40);
}

TEST(Stopping, ACancelTokenStopsWithoutAnException) {
  SumSettings options;
  options.cancel.emplace();
  options.cancel->cancel();
  Workspace workspace;
  Region sum;
  const Region square = rectangle(0, 0, 7, 7);
  for (const Method method : {Method::kReduced, Method::kSigned, Method::kFull}) {
    options.method = method;
    const Outcome outcome = minkowski_sum(square, square, options, workspace, sum);
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(outcome.error->code(), ErrorCode::kCancelled);
    EXPECT_TRUE(sum.empty());
  }
}

TEST(Stopping, ProgressIsToldTheStagesInOrderAndMayStopAtEach) {
  const Region p = ragged_frame(80, 400000, 7);
  std::vector<Stage> stages;
  SumSettings options;
  options.small = false;
  options.progress = [&](const Progress& progress) {
    const Stage stage = progress.stage;
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
    return true;
  };
  const Region expected = minkowski_sum(p, p, options);
  ASSERT_EQ(stages.size(), static_cast<std::size_t>(kSumStages));
  for (int i = 0; i < kSumStages; ++i) {
    EXPECT_EQ(static_cast<int>(stages[static_cast<std::size_t>(i)]), i);
  }
  Workspace workspace;
  Region sum;
  for (const Stage last : stages) {
    options.progress = [&](const Progress& progress) { return progress.stage != last; };
    const Outcome outcome = minkowski_sum(p, p, options, workspace, sum);
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(outcome.error->code(), ErrorCode::kCancelled);
    EXPECT_EQ(outcome.error->stage(), to_string(last));
  }
  options.progress = nullptr;
  EXPECT_TRUE(minkowski_sum(p, p, options, workspace, sum).ok());
  EXPECT_EQ(sum, expected);
}

TEST(Limits, AreNamedWhenExceeded) {
  const Region p = ragged_frame(80, 400000, 8);
  SumSettings options;
  Workspace workspace;
  Region sum;
  options.limits.max_segments = 100;
  Outcome outcome = minkowski_sum(p, p, options, workspace, sum);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->code(), ErrorCode::kLimitExceeded);
  EXPECT_NE(std::string(outcome.error->what()).find("max_segments"), std::string::npos);
  options.limits = {};
  options.limits.max_crossings = 3;
  outcome = minkowski_sum(p, p, options, workspace, sum);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error->code(), ErrorCode::kLimitExceeded);
  EXPECT_NE(std::string(outcome.error->what()).find("max_crossings"), std::string::npos);
}

}  // namespace

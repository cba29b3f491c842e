// A sum is the same on any number of threads: its bytes, its statistics, its errors.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "minksum/boolean.hpp"
#include "minksum/testing.hpp"
#include "support/generators.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::Random;

SumSettings on_threads(int threads) {
  SumSettings settings;
  settings.threads = threads;
  settings.share_all = true;
  settings.small = false;
  return settings;
}

/// Returns all numbers of the statistics but times.
std::vector<std::uint64_t> numbers(const Statistics& s) {
  return {s.convolution_segments,
          s.segments_kept,
          s.crossings,
          s.loops,
          s.rejected_by_nesting,
          s.rejected_by_collision,
          s.grid_cells,
          s.covered_cells,
          static_cast<std::uint64_t>(s.coordinate_bits),
          static_cast<std::uint64_t>(s.arithmetic),
          s.by_filter,
          s.by_fixed_width,
          s.by_arbitrary};
}

void expect_same(const Region& p, const Region& q, SumSettings settings) {
  const auto sum = [&](int threads) {
    settings.threads = threads;
    return detailed_sum(p, q, settings);
  };
  const DetailedSum one = sum(1);
  for (const int threads : {2, 3, 8}) {
    SCOPED_TRACE(threads);
    const DetailedSum several = sum(threads);
    EXPECT_EQ(several.sum.region, one.sum.region);
    for (std::size_t v = 0; v < one.sum.region.vertex_count(); ++v) {
      ASSERT_EQ(several.sum.region.origin(v), one.sum.region.origin(v));
    }
    EXPECT_EQ(several.tight, one.tight);
    EXPECT_EQ(numbers(several.statistics), numbers(one.statistics));
  }
}

TEST(Threads, SumsOfRandomShapes) {
  for (std::uint64_t seed = 1; seed <= 60 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const test::Pair pair = test::random_pair(random);
    expect_same(pair.p, pair.q, on_threads(1));
  }
}

TEST(Threads, SumsOfManySegments) {
  Random random(3);
  const Region star = test::spiky_star(random, 30, 100000);
  const Region other = test::spiky_star(random, 25, 90000);
  const Region comb = test::comb(25, 3, 1000);
  const Region lying = test::turned(test::comb(20, 2, 900));
  const Region holes = test::random_with_holes(random, 400, 12);
  for (const auto& [p, q] : {std::pair{&star, &other},
                             {&comb, &lying},
                             {&star, &comb},
                             {&holes, &lying},
                             {&holes, &comb},
                             {&comb, &comb}}) {
    for (const bool tight : {false, true}) {
      SumSettings settings = on_threads(1);
      settings.tight = tight;
      expect_same(*p, *q, settings);
      settings.cover = false;
      expect_same(*p, *q, settings);
    }
    SumSettings exact = on_threads(1);
    exact.filter = false;
    expect_same(*p, *q, exact);
  }
}

TEST(Threads, OfCoordinatesOfAnyLength) {
  Random random(5);
  const Region star = test::spiky_star(random, 12, 10000);
  for (const char* const factor : {"1/3", "1e14", "1e40", "1/7"}) {
    SCOPED_TRACE(factor);
    expect_same(test::scaled(star, *Rational::parse(factor)), star, on_threads(1));
  }
}

TEST(Threads, OfSizesFarApart) {
  // The edges of a notch are as small as the other operand. Their crowd has crossings, which are
  // found apart from the parts that threads share.
  Random random(6);
  const Region star = test::spiky_star(random, 20, 1000000);
  for (const char* const factor : {"1e16", "10000000000000000000000/7", "1e40"}) {
    SCOPED_TRACE(factor);
    const Region square = test::scaled(test::rectangle(0, 0, 1, 1), *Rational::parse(factor));
    expect_same(subtract(square, star), star, on_threads(1));
  }
  // Sums of fewer segments after one of more, in the same memory.
  Workspace memory;
  const Region square = test::scaled(test::rectangle(0, 0, 1, 1), *Rational::parse("1e16"));
  for (const int spikes : {25, 12, 18}) {
    const Region small = test::spiky_star(random, spikes, 1000000);
    const Region huge = subtract(square, small);
    for (const int threads : {1, 3}) {
      SumSettings settings = on_threads(threads);
      settings.memory = &memory;
      EXPECT_EQ(detailed_sum(huge, small, settings).sum.region, minkowski_sum(huge, small));
    }
  }
}

TEST(Threads, WorkspacesAreReused) {
  Random random(7);
  Workspace memory;
  for (int i = 0; i < 20; ++i) {
    const test::Pair pair = test::random_pair(random);
    SumSettings settings = on_threads(1 + i % 4);
    settings.memory = &memory;
    EXPECT_EQ(minkowski_sum(pair.p, pair.q, settings), minkowski_sum(pair.p, pair.q));
  }
}

TEST(Threads, WorkspacesAreReusedAfterSumsThatWereStopped) {
  // Many segments in cells of grids of many sizes, sorted in as many slices as there are threads.
  Random random(8);
  const Region star = test::spiky_star(random, 90, 1000000);
  const Region other = test::spiky_star(random, 80, 90000);
  const Region sum = minkowski_sum(star, other);
  Workspace memory;
  for (std::size_t last = 0, i = 0; last < 400; last += 1 + last / 10, ++i) {
    SCOPED_TRACE(last);
    SumSettings settings = on_threads(std::array{3, 1, 8, 2, 2}[i % 5]);
    settings.grid = std::array{32, 512, 64}[i % 3];
    Region result;
    ASSERT_TRUE(minkowski_sum(star, other, settings, memory, result).ok());
    EXPECT_EQ(result, sum);
    std::size_t looks = 0;
    settings.progress = [&](const Progress&) { return looks++ < last; };
    const Outcome outcome = minkowski_sum(star, other, settings, memory, result);
    if (!outcome.ok()) {
      EXPECT_EQ(outcome.error->code(), ErrorCode::kCancelled);
    }
  }
}

TEST(Threads, LimitsAreTheSame) {
  Random random(3);
  const Region star = test::spiky_star(random, 60, 100000);
  const Region other = test::spiky_star(random, 50, 90000);
  const std::uint64_t crossings = detailed_sum(star, other, on_threads(1)).statistics.crossings;
  for (const int threads : {1, 2, 3, 8}) {
    SumSettings settings = on_threads(threads);
    settings.limits.max_crossings = crossings;
    EXPECT_NO_THROW(static_cast<void>(minkowski_sum(star, other, settings)));
    settings.limits.max_crossings = crossings - 1;
    try {
      static_cast<void>(minkowski_sum(star, other, settings));
      ADD_FAILURE() << "no limit";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
      EXPECT_NE(std::string(error.what()).find("Limits::max_crossings"), std::string::npos);
    }
  }
}

TEST(Threads, CallbacksStayOnTheCallersThread) {
  Random random(3);
  const Region star = test::spiky_star(random, 60, 100000);
  const Region other = test::spiky_star(random, 50, 90000);
  const std::thread::id caller = std::this_thread::get_id();
  int looks = 0;
  int last = 1 << 30;
  SumSettings settings = on_threads(3);
  settings.progress = [&](const Progress&) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return looks++ < last;
  };
  const Region sum = minkowski_sum(star, other, settings);
  const int all = looks;
  Workspace memory;
  settings.memory = &memory;
  for (last = 0; last < all; last = 2 * last + 1) {
    looks = 0;
    Region result = sum;
    try {
      result = minkowski_sum(star, other, settings);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kCancelled);
      EXPECT_EQ(looks, last + 1);
    }
    EXPECT_EQ(result, sum);
  }
  settings.progress = [&](const Progress& progress) -> bool {
    if (progress.stage == Stage::kArrangement) throw std::out_of_range("mine");
    return true;
  };
  EXPECT_THROW(static_cast<void>(minkowski_sum(star, other, settings)), std::out_of_range);
  settings.progress = {};
  EXPECT_EQ(minkowski_sum(star, other, settings), sum);
}

}  // namespace
}  // namespace minksum

// Tests that every operation ends when its token says stop, at any time, and leaves nothing behind.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>

#include "minksum/minksum.hpp"
#include "minksum/testing.hpp"
#include "support/cancel_cases.hpp"
#include "support/polygon_kinds.hpp"

namespace minksum {
namespace {

/// A token that says stop at its n-th look and all later ones.
class Stopper {
 public:
  explicit Stopper(std::uint64_t at) : at_(at) {}
  [[nodiscard]] CancelToken token() {
    return CancelToken::polling([this] { return looks_.fetch_add(1) + 1 >= at_; });
  }
  [[nodiscard]] std::uint64_t looks() const { return looks_.load(); }

 private:
  std::uint64_t at_;
  std::atomic<std::uint64_t> looks_{0};
};

constexpr std::uint64_t kNever = ~std::uint64_t{0};

/// Returns whether the operation ended because it was cancelled.
bool is_cancelled(const test::CancelCase& hard, const Options& options) {
  try {
    hard.run(options);
    return false;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled) << error.what();
    return error.code() == ErrorCode::kCancelled;
  }
}

TEST(Cancel, EveryOperationEndsAtAnyLook) {
  for (const test::CancelCase& hard : test::cancel_cases(60)) {
    SCOPED_TRACE(hard.operation + ", " + hard.input);
    bool ended = true;
    for (std::uint64_t at = 1; ended && at < 256; at *= 2) {
      Stopper stopper(at);
      ended = is_cancelled(hard, {.cancel = stopper.token()});
      // The operation was told to stop, or ended before.
      EXPECT_EQ(ended, stopper.looks() >= at);
    }
  }
}

TEST(Cancel, EveryOperationTellsItsProgressAndEndsWhereThatSaysStop) {
  for (const test::CancelCase& hard : test::cancel_cases(60)) {
    if (hard.operation == "write, read") continue;  // texts have a token alone
    SCOPED_TRACE(hard.operation + ", " + hard.input);
    for (const std::uint64_t at : {1U, 2U, 16U}) {
      std::atomic<std::uint64_t> calls{0};
      const auto progress = [&](const Progress& p) {
        EXPECT_LE(p.done, p.parts);
        return calls.fetch_add(1) + 1 < at;
      };
      const bool ended = is_cancelled(hard, {.progress = progress});
      EXPECT_EQ(ended, calls >= at);
    }
  }
}

TEST(Cancel, LooksGrowWithTheWork) {
  // The n² pairs of edges that cross count at least as many units of work.
  SumSettings options;
  Stopper stopper(kNever);
  options.cancel = stopper.token();
  options.method = Method::kFull;
  const Region teeth = test::comb(80, 1, 1000);
  const DetailedSum sum = detailed_sum(teeth, test::turned(teeth), options);
  EXPECT_GT(stopper.looks(), sum.statistics.crossings >> 15U);
}

TEST(Cancel, LooksGrowWithTheVerticesOfADisc) {
  Stopper stopper(kNever);
  Options options;
  options.cancel = stopper.token();
  OffsetOptions fine;
  fine.tolerance = Rational(1, 1'000'000'000);
  const Geometry disc = offset(Geometry({}, {}, {Point{}}), 1, fine, options);
  // Each vertex is placed, verified and written, each of which counts as 32 units.
  EXPECT_GT(disc.region.vertex_count(), 10'000U);
  EXPECT_GT(stopper.looks(), disc.region.vertex_count() * 64 >> 15U);
}

TEST(Cancel, ResultIsEmptyAndTheWorkspaceWorksAfterwards) {
  const Region p = test::comb(30, 1, 1000);
  const Region q = test::turned(p);
  const Region sum = minkowski_sum(p, q);
  Workspace workspace;
  for (std::uint64_t at = 1; at < 64; at *= 2) {
    Stopper stopper(at);
    SumSettings options;
    options.cancel = stopper.token();
    Region result = p;
    const Outcome outcome = minkowski_sum(p, q, options, workspace, result);
    if (outcome.ok()) {
      EXPECT_EQ(result, sum);
    } else {
      EXPECT_EQ(outcome.error->code(), ErrorCode::kCancelled);
      EXPECT_TRUE(result.empty());
    }
    ASSERT_TRUE(minkowski_sum(p, q, Options{}, workspace, result).ok());
    EXPECT_EQ(result, sum);
  }
}

TEST(Cancel, WhatAPollingFunctionThrowsIsThrownOn) {
  struct Stop {};
  SumSettings options;
  options.cancel = CancelToken::polling([]() -> bool { throw Stop{}; });
  const Region p = test::comb(30, 1, 1000);
  EXPECT_THROW(static_cast<void>(minkowski_sum(p, p, options)), Stop);
}

TEST(Cancel, APollingTokenIsAskedNoMoreOnceItSaidStop) {
  Stopper stopper(1);
  const CancelToken token = stopper.token();
  EXPECT_TRUE(token.cancelled());
  EXPECT_TRUE(token.cancelled());
  EXPECT_EQ(stopper.looks(), 1U);
  Stopper never(kNever);
  const CancelToken told = never.token();
  told.cancel();
  EXPECT_TRUE(told.cancelled());
  EXPECT_EQ(never.looks(), 0U);
}

}  // namespace
}  // namespace minksum

// A team does every task once, ends as the caller wishes, and passes on what is thrown.
#include "machine/team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "machine/in_order.hpp"
#include "machine/share_by_key.hpp"
#include "support/random.hpp"
#include "support/threads.hpp"

namespace minksum {
namespace {

constexpr std::size_t kTasks = 100;

/// Shares tasks that count themselves. Returns how often each was done.
std::vector<int> counts(Team& team, Cancellation& cancellation) {
  std::vector<int> counts(kTasks);
  cancellation.join(team);
  share(kTasks, cancellation, [&](std::size_t task, std::size_t member, Cancellation& own) {
    EXPECT_LT(member, team.size());
    own.check();
    ++counts[task];
  });
  return counts;
}

TEST(Team, DoesEachTaskOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    Team team(threads, true);
    EXPECT_EQ(team.size(), static_cast<std::size_t>(threads));
    Cancellation never;
    for (int round = 0; round < 50; ++round) {
      EXPECT_EQ(counts(team, never), std::vector<int>(kTasks, 1));
    }
  }
}

TEST(Team, DividesAllElements) {
  for (const std::size_t size : {0U, 1U, 7U, 100U}) {
    for (const std::size_t tasks : {1U, 3U, 16U}) {
      EXPECT_EQ(begin_of(0, tasks, size), 0U);
      EXPECT_EQ(begin_of(tasks, tasks, size), size);
      for (std::size_t task = 0; task < tasks; ++task) {
        const std::size_t count = begin_of(task + 1, tasks, size) - begin_of(task, tasks, size);
        EXPECT_LE(count - size / tasks, 1U);
      }
    }
  }
}

TEST(ShareByKey, ListsWhatOneThreadLists) {
  using Keyed = std::pair<std::uint32_t, std::uint32_t>;
  test::Random random(20);
  for (const std::uint32_t keys : {1U, 7U, 1000U}) {
    std::vector<std::vector<Keyed>> lists(5);
    std::vector<Keyed> all;
    for (std::size_t i = 0; i < 20'000; ++i) {
      all.emplace_back(random.next() % keys, i);
      lists[i * i / 100'000'000].push_back(all.back());
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Keyed& a, const Keyed& b) { return a.first < b.first; });
    for (const int threads : {1, 2, 3, 8}) {
      Team team(threads, true);
      Cancellation never;
      never.join(team);
      std::vector<std::uint32_t> begin;
      std::vector<Keyed> values;
      share_by_key(
          keys, lists.size(), [&](std::size_t i) -> const auto& { return lists[i]; },
          [](std::size_t, const Keyed& one) { return std::pair(one.first, one); }, never, begin,
          values);
      EXPECT_EQ(values, all);
      ASSERT_EQ(begin.size(), keys + 1);
      for (std::uint32_t key = 0; key < keys; ++key) {
        for (std::uint32_t i = begin[key]; i < begin[key + 1]; ++i) EXPECT_EQ(values[i].first, key);
      }
      EXPECT_EQ(begin.back(), all.size());
    }
  }
}

TEST(ShareByKey, SlicesTakeNoMoreMemoryThanValues) {
  Team team(8, true);
  Cancellation never;
  never.join(team);
  EXPECT_EQ(slices_for<std::uint64_t>(1000, 10, never), 8U);
  EXPECT_EQ(slices_for<std::uint64_t>(1000, 499, never), 4U);
  EXPECT_EQ(slices_for<std::uint64_t>(1000, 100'000, never), 1U);
}

TEST(Team, LeavesLittleWorkToOneThread) {
  EXPECT_EQ(Team(8).tasks_for(1000), 1U);
  EXPECT_EQ(Team(1).tasks_for(1'000'000'000), 1U);
  EXPECT_GT(Team(2).tasks_for(1'000'000'000), 1U);
  EXPECT_EQ(tasks_for(1'000'000'000, Cancellation()), 1U);  // nobody has joined a team
}

TEST(Team, PassesOnTheFirstError) {
  Team team(4, true);
  Cancellation never;
  never.join(team);
  for (int round = 0; round < 50; ++round) {
    try {
      share(kTasks, never, [&](std::size_t task, std::size_t member, Cancellation&) {
        if (member != 0 && task >= 10) throw std::out_of_range(std::to_string(task));
        if (member == 0) std::this_thread::yield();
      });
    } catch (const std::out_of_range& error) {
      EXPECT_GE(std::stoi(error.what()), 10);
    }
  }
  EXPECT_THROW(share(kTasks, never,
                     [&](std::size_t, std::size_t, Cancellation&) { throw std::bad_alloc(); }),
               std::bad_alloc);
  EXPECT_EQ(counts(team, never), std::vector<int>(kTasks, 1));  // the team goes on
}

/// Whoever does the first task that passes a limit: the caller, or a helper.
TEST(Team, PassesOnTheLimitThatOneThreadWouldPass) {
  for (const int threads : {1, 2, 8}) {
    Team team(threads, true);
    Cancellation never;
    never.join(team);
    for (std::size_t round = 0; round < 200; ++round) {
      const std::size_t first = round % kTasks;
      try {
        share(kTasks, never, [&](std::size_t task, std::size_t, Cancellation&) {
          if (task % 3 == round % 3) std::this_thread::yield();
          if (task >= first) throw Error(ErrorCode::kLimitExceeded, std::to_string(task));
        });
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.what(), std::to_string(first));
      }
    }
  }
}

TEST(InOrder, VisitsAllBeforeTheFirstThatFails) {
  struct NoMemory {};
  for (const int threads : {1, 2, 8}) {
    for (std::size_t round = 0; round < 300; ++round) {
      const std::size_t first = round % 40;
      std::size_t visited = 0;
      const auto make = [&](std::size_t i, NoMemory&) {
        if (i >= first) throw std::out_of_range(std::to_string(i));
        if (i % 3 == round % 3) std::this_thread::yield();
        return std::to_string(i);
      };
      const auto visit = [&](std::size_t i, const std::string& result) {
        EXPECT_EQ(i, visited++);
        EXPECT_EQ(result, std::to_string(i));
      };
      try {
        for_each_in_order<std::string, NoMemory>(64, threads, Options{}, make, visit);
        ADD_FAILURE() << "no error";
      } catch (const std::out_of_range& error) {
        EXPECT_EQ(error.what(), std::to_string(first));
      }
      EXPECT_EQ(visited, first);
    }
  }
}

TEST(Team, AsksTheCallerOnItsOwnThread) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> asked{0};
  Options options;
  options.progress = [&](const Progress&) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return ++asked < 20;
  };
  Team team(3, true);
  Cancellation cancellation(options);
  cancellation.join(team);
  const auto endless = [](std::size_t, std::size_t, Cancellation& own) {
    while (true) own.check();
  };
  EXPECT_THROW(share(kTasks, cancellation, endless), Error);
  EXPECT_EQ(asked, 20);
}

TEST(Team, AsksTheCallerWhileItWaits) {
  MINKSUM_NEEDS_THREADS();
  int asked = 0;
  Options options;
  options.progress = [&](const Progress&) { return ++asked < 20; };
  Team team(3, true);
  Cancellation cancellation(options);
  cancellation.join(team);
  std::atomic<bool> begun{false};
  const auto others_endless = [&](std::size_t task, std::size_t member, Cancellation& own) {
    if (member == 0) {
      while (task == 0 && !begun) std::this_thread::yield();
      return;
    }
    begun = true;
    while (true) own.check();
  };
  EXPECT_THROW(share(2, cancellation, others_endless), Error);
  EXPECT_EQ(asked, 20);
}

}  // namespace
}  // namespace minksum

// Makes many results on several threads, and hands them out in order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <vector>

#include "machine/team.hpp"
#include "machine/threads.hpp"

namespace minksum {

/// Calls make(i, memory) for all i < count on so many threads, each with a Memory of its own. The
/// calling thread is one of them, and calls visit(i, result) in order of i. If make(i) throws, the
/// error is thrown in place of visit(i), after all threads have ended. `options` are those of a
/// result.
///
/// Results are made in rounds, and each round is visited before the next one begins. So only a few
/// results wait to be visited.
template <class Result, class Memory, class Make, class Visit>
void for_each_in_order(std::size_t count, int threads, const Options& options, const Make& make,
                       const Visit& visit) {
  constexpr std::size_t kMadeByMember = 8;
  const std::size_t used = std::clamp<std::size_t>(count, 1, thread_count(threads));
  Team team(static_cast<int>(used));
  Cancellation cancellation(options);
  cancellation.join(team);
  std::vector<std::optional<Memory>> memories(used);
  struct Made {
    std::optional<Result> result;
    std::exception_ptr error;
  };
  std::vector<Made> round(used == 1 ? 1 : kMadeByMember * used);
  for (std::size_t begin = 0; begin < count; begin += round.size()) {
    const std::size_t size = std::min(round.size(), count - begin);
    std::atomic<std::size_t> first_failed = size;
    share(size, cancellation, [&](std::size_t task, std::size_t member, Cancellation&) {
      if (task > first_failed) return;
      try {
        if (!memories[member]) memories[member].emplace();
        round[task].result.emplace(make(begin + task, *memories[member]));
      } catch (...) {
        round[task].error = std::current_exception();
        std::size_t known = first_failed;
        while (task < known && !first_failed.compare_exchange_weak(known, task)) {
        }
      }
    });
    for (std::size_t task = 0; task < size; ++task) {
      if (round[task].error) std::rethrow_exception(round[task].error);
      visit(begin + task, *round[task].result);
      round[task].result.reset();
    }
  }
}

}  // namespace minksum

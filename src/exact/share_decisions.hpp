// Shares tasks that take exact decisions.
#pragma once

#include <cstddef>
#include <vector>

#include "exact/predicates.hpp"
#include "machine/team.hpp"

namespace minksum {

/// Calls work(task, member, predicates) for each task, as `share` does. Each task's decisions are
/// counted by themselves, and then added: their number does not depend on the threads.
template <class Work>
void share_decisions(std::size_t tasks, Predicates& predicates, Work work) {
  if (tasks == 0) return;
  if (tasks == 1) return work(std::size_t{0}, std::size_t{0}, predicates);
  std::vector<LadderCounts> counts(tasks);
  share(tasks, predicates.cancellation(),
        [&](std::size_t task, std::size_t member, Cancellation& own) {
          Predicates decide = predicates.for_thread(own);
          work(task, member, decide);
          counts[task] = decide.counts();
        });
  for (const LadderCounts& count : counts) predicates.add(count);
}

}  // namespace minksum

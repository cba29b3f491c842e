// Shares the work of one operation between several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "machine/make_room.hpp"
#include "machine/threads.hpp"

namespace minksum {

/// The thread that calls an operation, and the threads that help it. The helpers start when there
/// is enough work for the first time, wait between two pieces of work, and end with the team.
///
/// `Cancellation::join` makes an operation the work of a team. Then `share` divides the work, and
/// `tasks_for` tells whether that pays. Helpers have no team, so nothing is divided twice.
class Team {
 public:
  /// Calls work(task, member, cancellation). `member` is 0 for the calling thread.
  using Work = std::function<void(std::size_t, std::size_t, Cancellation&)>;

  /// `threads` is that of Options: the calling thread included, and 0 for one for each core.
  /// With `share_all`, even work is shared that is too little to gain.
  explicit Team(int threads, bool share_all = false);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Returns how many members the team has, the calling thread included.
  [[nodiscard]] std::size_t size();
  /// Returns into how many tasks to divide so many units of work; 1 if dividing does not pay.
  [[nodiscard]] std::size_t tasks_for(std::uint64_t units);
  /// Does the work of `share`. A helper that cannot be started is done without.
  void run(std::size_t tasks, Cancellation& cancellation, const Work& work);

 private:
  class Helpers;

  int threads_;
  bool share_all_;
  std::size_t size_ = 0;  ///< 0 until somebody asks: the number of cores may change later
  std::unique_ptr<Helpers> helpers_;
};

/// Returns into how many tasks to divide so many units of work (see Cancellation); 1 if one thread
/// does it all. No result may depend on this number.
[[nodiscard]] inline std::size_t tasks_for(std::uint64_t units, const Cancellation& cancellation) {
  return !kHasThreads || cancellation.team() == nullptr ? 1 : cancellation.team()->tasks_for(units);
}
/// Returns how many members `share` has: each `member` is less.
[[nodiscard]] inline std::size_t members_of(const Cancellation& cancellation) {
  return !kHasThreads || cancellation.team() == nullptr ? 1 : cancellation.team()->size();
}
/// Returns where the task begins if `size` elements are divided into so many tasks.
[[nodiscard]] constexpr std::size_t begin_of(std::size_t task, std::size_t tasks,
                                             std::size_t size) {
  return size / tasks * task + std::min(task, size % tasks);
}

/// Calls work(task, member, cancellation) for each task, some at a time on different threads. Each
/// member has a `cancellation` of its own, and begins tasks in their order.
///
/// The calling thread alone looks at the caller's token and calls the caller's progress callback,
/// also while it waits for the others. If it finds that the operation is to end, or fails in
/// another way, all others end at their next look, and that error is passed on. If a helper fails,
/// or the calling thread passes a limit, the tasks that were begun end, and the error of the first
/// task that failed is passed on.
template <class Work>
void share(std::size_t tasks, Cancellation& cancellation, Work work) {
  if (!kHasThreads || tasks <= 1 || cancellation.team() == nullptr) {
    for (std::size_t task = 0; task < tasks; ++task) work(task, std::size_t{0}, cancellation);
  } else {
    cancellation.team()->run(tasks, cancellation, std::ref(work));
  }
}

/// Calls visit(i, cancellation) for all i < size, some at a time on different threads if that pays.
/// One takes about `units` of work. A visit that may take far longer counts its own work.
template <class Visit>
void share_each(std::size_t size, std::uint64_t units, Cancellation& cancellation, Visit visit) {
  const std::size_t tasks = tasks_for(units * size, cancellation);
  share(tasks, cancellation, [&](std::size_t task, std::size_t, Cancellation& own) {
    const std::size_t first = begin_of(task, tasks, size);
    in_pieces(begin_of(task + 1, tasks, size) - first, own,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = first + begin; i < first + end; ++i) visit(i, own);
              });
  });
}

}  // namespace minksum

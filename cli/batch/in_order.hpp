// Runs tasks on many threads, with results in the order of the tasks and bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::cli {

struct ReadyOperation;

/// Keeps what one thread reuses from task to task.
struct Worker {
  Workspace memory;
  Geometry geometry;               ///< the last result, where its memory is worth keeping
  io::Coordinates system;          ///< the reference system of the job's operands
  std::vector<std::string> notes;  ///< what the job's result has lost by rounding
  /// Operations with their options, by the text of a job that asks for them.
  std::map<std::string, std::shared_ptr<const ReadyOperation>> ready;
};

/// The result of a task: its lines, and how many jobs they are of.
struct Done {
  std::string lines;
  std::uint64_t jobs = 0;
  std::uint64_t failed = 0;
};

struct Task {
  std::function<Done(Worker&)> run;
  std::size_t bytes = 0;  ///< roughly the memory that the task holds
};

/// Supplies tasks and takes their results. One thread calls all of these functions.
struct Work {
  /// Returns the next task, or nothing at the end. May wait for input.
  std::function<std::optional<Task>()> next;
  /// Returns whether `next` can return without waiting. If not, finished results are written first.
  /// A program at the other end of a pipe may wait for one before it asks for more.
  std::function<bool()> is_at_hand = [] { return true; };
  /// Takes the results of tasks, in the order of the tasks.
  std::function<void(const Done&)> consume;
};

/// Returns the number of threads, or that of the cores for 0.
[[nodiscard]] int threads_or_all(int threads);

/// Runs all tasks on `threads` threads.
///
/// At any time, at most 64 tasks for each thread, or fewer if they are large, have come from `next`
/// and not yet gone to `consume`. That bounds the memory. An exception of a task or function ends
/// the run and is rethrown; of `next`, once the tasks before it are done and consumed.
void run_in_order(int threads, const Work& work);

}  // namespace minksum::cli

// Work for all cores whose results come in order, with bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "minksum/minkowski_sum.hpp"

namespace minksum::cli {

struct ReadyOperation;

/// What a thread keeps from task to task.
struct Worker {
  Workspace workspace;
  Region sum;
  Geometry geometry;
  /// Operations with their options, by the text that asks for them.
  std::map<std::string, std::shared_ptr<const ReadyOperation>> ready;
};

/// What came out of a task: lines, and of how many jobs.
struct Done {
  std::string lines;
  std::uint64_t jobs = 0;
  std::uint64_t failed = 0;
};

struct Task {
  std::function<Done(Worker&)> run;
  std::size_t bytes = 0;  ///< about how much memory it holds
};

/// What there is to do, and what becomes of it; called by one thread.
struct Work {
  /// The next task; nothing at the end. May wait, for input.
  std::function<std::optional<Task>()> next;
  /// Whether `next` would not wait. If it would, what is done goes out first, so that a program
  /// that asks for one thing after the other through a pipe has its answer.
  std::function<bool()> is_at_hand = [] { return true; };
  /// Takes what came out of tasks, in their order.
  std::function<void(const Done&)> consume;
};

/// Runs all tasks on `threads` threads.
///
/// At a time there are at most 64 tasks a thread, or fewer if they are large, that were taken and
/// not yet consumed: that bounds the memory. What a task or a function throws ends all, and is
/// thrown.
void run_in_order(int threads, const Work& work);

}  // namespace minksum::cli

// Does work on many threads and hands out the results in order.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "machine/threads.hpp"

namespace minksum {

/// Calls make(i, memory) for all i < count on so many threads, each with a Memory of its own. The
/// calling thread calls visit(i, result) in order of i.
///
/// Only a few results wait to be visited. If make(i) throws, the error is thrown in place of
/// visit(i), after all threads have ended. If a thread cannot be started, the others do its
/// work; run() throws if there are none.
template <class Result, class Memory, class Make, class Visit>
class InOrder {
 public:
  InOrder(std::size_t count, std::size_t threads, const Make& make, const Visit& visit)
      : count_(count), threads_(threads), make_(make), visit_(visit), slots_(2 * threads + 1) {}
  InOrder(const InOrder&) = delete;
  InOrder& operator=(const InOrder&) = delete;

  void run() {
    Workers workers(*this);
    workers.threads.reserve(threads_);
    for (std::size_t i = 0; i < threads_; ++i) {
      try {
        workers.threads.emplace_back([this] { work(); });
      } catch (const std::system_error&) {
        if (workers.threads.empty()) throw;
        break;
      }
    }
    for (std::size_t i = 0; i < count_; ++i) {
      Slot slot = take(i);
      if (slot.error) std::rethrow_exception(slot.error);
      visit_(i, *slot.result);
    }
  }

 private:
  struct Slot {
    std::optional<Result> result;
    std::exception_ptr error;
    [[nodiscard]] bool filled() const { return result || error; }
  };
  /// Stops and joins the threads, even if something is thrown.
  struct Workers {
    InOrder& all;
    std::vector<std::thread> threads;
    explicit Workers(InOrder& of) : all(of) {}
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers() {
      {
        const std::lock_guard lock(all.mutex_);
        all.stopped_ = true;
        all.changed_.notify_all();
      }
      for (std::thread& thread : threads) thread.join();
    }
  };

  Slot take(std::size_t i) {
    std::unique_lock lock(mutex_);
    Slot& slot = slots_[i % slots_.size()];
    changed_.wait(lock, [&] { return slot.filled(); });
    Slot taken = std::exchange(slot, {});
    visited_ = i + 1;
    changed_.notify_all();
    return taken;
  }

  void work() {
    block_signals_in_this_thread();
    std::optional<Memory> memory;  // made here, where running out of memory is caught
    while (true) {
      std::size_t i = 0;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] {
          return stopped_ || next_ == count_ || next_ < visited_ + slots_.size();
        });
        if (stopped_ || next_ == count_) return;
        i = next_++;
      }
      Slot made;
      try {
        if (!memory) memory.emplace();
        made.result.emplace(make_(i, *memory));
      } catch (...) {
        made.error = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      slots_[i % slots_.size()] = std::move(made);
      changed_.notify_all();
    }
  }

  std::size_t count_;
  std::size_t threads_;
  const Make& make_;
  const Visit& visit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Slot> slots_;
  std::size_t next_ = 0;
  std::size_t visited_ = 0;
  bool stopped_ = false;
};

/// Does the work of InOrder. If one thread is enough, the calling thread does it.
template <class Result, class Memory, class Make, class Visit>
void for_each_in_order(std::size_t count, int threads, const Make& make, const Visit& visit) {
  const std::size_t used = std::min(thread_count(threads), count);
  if (used > 1) return InOrder<Result, Memory, Make, Visit>(count, used, make, visit).run();
  Memory memory;
  for (std::size_t i = 0; i < count; ++i) {
    Result result = make(i, memory);
    visit(i, result);
  }
}

}  // namespace minksum

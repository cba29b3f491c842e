#include "batch/in_order.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "process/failure.hpp"
#include "process/process.hpp"

namespace minksum::cli {
namespace {

constexpr std::size_t kTasksPerThread = 64;
constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

// A task under way. Its address is stable, because a thread works on it.
struct Slot {
  Task task;
  Done result;
  std::exception_ptr failure;
  bool done = false;
};

class Pool {
 public:
  explicit Pool(int threads) {
    threads_.reserve(static_cast<std::size_t>(threads));
    start(threads);
    if (threads_.empty()) throw Failure(kLimitExceeded, "the system gives no thread to work on");
  }
  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  [[nodiscard]] std::size_t threads() const { return threads_.size(); }
  [[nodiscard]] bool idle() const { return slots_.empty(); }
  [[nodiscard]] bool has_room() const {
    return slots_.empty() || (slots_.size() < kTasksPerThread * threads() && bytes_ < kMaxBytes);
  }
  void add(Task task) {
    bytes_ += task.bytes;
    {
      const std::lock_guard lock(mutex_);
      slots_.push_back(std::make_unique<Slot>());
      slots_.back()->task = std::move(task);
      waiting_.push_back(slots_.back().get());
    }
    wake_.notify_one();
  }
  [[nodiscard]] bool first_is_done() {
    const std::lock_guard lock(mutex_);
    return slots_.front()->done;
  }
  // Waits for the oldest task, and returns its result.
  Done take() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return slots_.front()->done; });
    const std::unique_ptr<Slot> slot = std::move(slots_.front());
    slots_.pop_front();
    lock.unlock();
    bytes_ -= slot->task.bytes;
    if (slot->failure) std::rethrow_exception(slot->failure);
    return std::move(slot->result);
  }

 private:
  // If memory or threads run out, fewer threads do the work.
  void start(int threads) {
    // Only the main thread takes signals, as it would without this pool.
    const SignalsBlocked blocked;
    try {
      for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
  }
  void work() {
    std::optional<Worker> worker;  // made in a task, which then reports a failure
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      if (ending_) return;
      Slot& slot = *waiting_.front();
      waiting_.pop_front();
      lock.unlock();
      try {
        if (!worker) worker.emplace();
        slot.result = slot.task.run(*worker);
      } catch (...) {
        slot.failure = std::current_exception();
      }
      slot.task.run = nullptr;  // frees what the task holds
      lock.lock();
      slot.done = true;
      if (&slot == slots_.front().get()) done_.notify_one();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  std::deque<std::unique_ptr<Slot>> slots_;  // not yet consumed; only one thread changes this
  std::deque<Slot*> waiting_;                // slots whose work has not begun
  bool ending_ = false;
  std::size_t bytes_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace

int threads_or_all(int threads) {
  if (threads > 0) return threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void run_in_order(int threads, const Work& work) {
  Pool pool(threads);
  bool more = true;
  std::exception_ptr no_more;  // why `next` gave no task
  while (more || !pool.idle()) {
    while (more && pool.has_room() && (pool.idle() || work.is_at_hand())) {
      std::optional<Task> task;
      try {
        task = work.next();
      } catch (...) {
        no_more = std::current_exception();
      }
      more = task.has_value();
      if (task) pool.add(std::move(*task));
      if (!pool.idle() && pool.first_is_done()) break;
    }
    if (!pool.idle()) work.consume(pool.take());
  }
  if (no_more) std::rethrow_exception(no_more);
}

}  // namespace minksum::cli

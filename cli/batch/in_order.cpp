#include "batch/in_order.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
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
  [[nodiscard]] bool idle() const { return pending_.empty(); }
  [[nodiscard]] bool has_room() const {
    return idle() || (pending_.size() < kTasksPerThread * threads() && bytes_ < kMaxBytes);
  }
  void add(Task task) {
    bytes_ += task.bytes;
    // The worker is made in a task, which then reports a failure.
    Job job([run = std::move(task.run)](std::optional<Worker>& worker) {
      if (!worker) worker.emplace();
      return run(*worker);
    });
    pending_.push_back({job.get_future(), task.bytes});
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(std::move(job));
    }
    wake_.notify_one();
  }
  [[nodiscard]] bool first_is_done() const {
    return pending_.front().result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  // Waits for the oldest task, and returns its result.
  Done take() {
    Pending first = std::move(pending_.front());
    pending_.pop_front();
    bytes_ -= first.bytes;
    return first.result.get();
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
    std::optional<Worker> worker;
    for (;;) {
      Job job;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
        if (ending_) return;
        job = std::move(waiting_.front());
        waiting_.pop_front();
      }
      job(worker);
    }
  }

  using Job = std::packaged_task<Done(std::optional<Worker>&)>;
  struct Pending {
    std::future<Done> result;
    std::size_t bytes;
  };

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Pending> pending_;  // tasks not yet consumed; only one thread sees this
  std::deque<Job> waiting_;      // tasks whose work has not begun
  bool ending_ = false;
  std::size_t bytes_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace

void run_in_order(int threads, const Work& work) {
  Pool pool(threads);
  bool more = true;
  while (more || !pool.idle()) {
    while (more && pool.has_room() && (pool.idle() || work.is_at_hand())) {
      std::optional<Task> task = work.next();
      more = task.has_value();
      if (task) pool.add(std::move(*task));
      if (!pool.idle() && pool.first_is_done()) break;
    }
    if (!pool.idle()) work.consume(pool.take());
  }
}

}  // namespace minksum::cli

#include "machine/team.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace minksum {
namespace {

/// Starting a thread and waking it takes some 100 microseconds. Work of so many units takes some
/// 0.6 milliseconds. With four times as many, 57 sums of 2 to 40 milliseconds took 1.045 times as
/// long on two threads; with a fourth, 38 sums of 0.2 to 3 milliseconds took 1.003 times as long.
constexpr std::uint64_t kUnitsToStart = 1 << 16;
/// Waking a thread that waits takes some 10 microseconds.
constexpr std::uint64_t kUnitsToWake = 1 << 14;
/// So many tasks for each member: even if the last task takes twice as long as the others, members
/// wait for less than a tenth of the time.
constexpr std::size_t kTasksPerMember = 16;
/// How long the calling thread waits for the others until it looks at the caller's token again.
constexpr std::chrono::milliseconds kWait{5};

}  // namespace

/// The helping threads, and the work that they share at present.
class Team::Helpers {
 public:
  explicit Helpers(std::size_t count) {
    threads_.reserve(count);
    for (std::size_t member = 1; member <= count; ++member) {
      try {
        threads_.emplace_back([this, member] { live(member); });
      } catch (const std::exception&) {
        break;  // the system gives no more threads, or no memory for them
      }
    }
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;
  ~Helpers() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void run(std::size_t tasks, Cancellation& cancellation, const Work& work) {
    {
      const std::lock_guard lock(mutex_);
      if (stop_.cancel->cancelled()) stop_.cancel = CancelToken();
      stage_ = cancellation.stage();
      work_ = &work;
      tasks_ = tasks;
      next_ = 0;
      open_ = true;
      failed_ = tasks;
      error_ = nullptr;
      ++round_;
    }
    begun_.notify_all();
    std::exception_ptr mine;
    try {
      for (std::size_t task = take(); task < tasks_; task = take()) {
        try {
          work(task, 0, cancellation);
        } catch (const Error& error) {
          if (error.code() != ErrorCode::kLimitExceeded) throw;
          fail(task);
        }
      }
      while (!others_have_ended()) cancellation.look();
    } catch (...) {
      mine = std::current_exception();
      stop_.cancel->cancel();
    }
    std::unique_lock lock(mutex_);
    open_ = false;
    ended_.wait(lock, [&] { return at_work_ == 0; });
    if (mine) std::rethrow_exception(mine);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }

 private:
  void live(std::size_t member) {
    block_signals_in_this_thread();
    std::uint64_t round = 0;
    std::unique_lock lock(mutex_);
    while (true) {
      begun_.wait(lock, [&] { return over_ || (open_ && round != round_); });
      if (over_) return;
      round = round_;
      ++at_work_;
      lock.unlock();
      do_tasks(member);
      lock.lock();
      if (--at_work_ == 0) ended_.notify_all();
    }
  }
  /// Returns the next task, or `tasks_` if there is none.
  std::size_t take() {
    const std::lock_guard lock(mutex_);
    return error_ || next_ >= tasks_ || stop_.cancel->cancelled() ? tasks_ : next_++;
  }
  void do_tasks(std::size_t member) {
    std::size_t task = take();
    try {
      Cancellation cancellation(stop_, stage_);
      for (; task < tasks_; task = take()) (*work_)(task, member, cancellation);
    } catch (...) {
      fail(task);  // no task is taken after that
    }
  }
  /// Keeps the present error, unless an earlier task has failed.
  void fail(std::size_t task) {
    const std::lock_guard lock(mutex_);
    if (task > failed_) return;
    failed_ = task;
    error_ = std::current_exception();
  }
  [[nodiscard]] bool others_have_ended() {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, kWait, [&] { return at_work_ == 0; });
  }

  std::vector<std::thread> threads_;
  Options stop_{.cancel = CancelToken()};  ///< the options of the helpers' cancellations
  std::mutex mutex_;
  std::condition_variable begun_;
  std::condition_variable ended_;
  bool over_ = false;
  std::uint64_t round_ = 0;  ///< how often work was shared
  // The work of this round. A helper that wakes up too late does not take part.
  const Work* work_ = nullptr;
  Stage stage_ = Stage::kOperands;
  std::size_t tasks_ = 0;
  std::size_t next_ = 0;
  bool open_ = false;         ///< whether helpers may still begin
  std::size_t at_work_ = 0;   ///< helpers that have begun and not ended
  std::size_t failed_ = 0;    ///< the first task that failed
  std::exception_ptr error_;  ///< of that task
};

Team::Team(int threads, bool share_all) : threads_(threads), share_all_(share_all) {}
Team::~Team() = default;

std::size_t Team::size() {
  if (size_ == 0) size_ = threads_ == 1 ? 1 : thread_count(threads_);
  return size_;
}

std::size_t Team::tasks_for(std::uint64_t units) {
  if (threads_ == 1) return 1;
  if (!share_all_ && units < (helpers_ ? kUnitsToWake : kUnitsToStart)) return 1;
  const std::size_t members = size();
  return members == 1 ? 1 : kTasksPerMember * members;
}

void Team::run(std::size_t tasks, Cancellation& cancellation, const Work& work) {
  if (!helpers_) helpers_ = std::make_unique<Helpers>(size() - 1);
  helpers_->run(tasks, cancellation, work);
}

}  // namespace minksum

#include "process/watchdog.hpp"

namespace minksum::cli {

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

// A deadline that has passed stays in the list until its watch ends.
void Watchdog::run() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    const Clock::time_point now = Clock::now();
    Clock::time_point next = Clock::time_point::max();
    for (const auto& [deadline, token] : deadlines_) {
      if (token.cancelled()) continue;
      if (deadline > now) {
        next = deadline;
        break;
      }
      token.cancel();
    }
    if (next == Clock::time_point::max()) {
      changed_.wait(lock);
    } else {
      changed_.wait_until(lock, next);
    }
  }
}

Watchdog::Watch::Watch(Watchdog& dog, double seconds) : dog_(dog) {
  if (!(seconds > 0)) return;
  token_.emplace();
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(seconds));
  {
    const std::lock_guard lock(dog_.mutex_);
    if (!dog_.thread_.joinable()) dog_.thread_ = std::thread([&dog] { dog.run(); });
    place_ = dog_.deadlines_.emplace(deadline, *token_);
  }
  dog_.changed_.notify_one();
}

Watchdog::Watch::~Watch() {
  if (!token_) return;
  const std::lock_guard lock(dog_.mutex_);
  dog_.deadlines_.erase(place_);
}

}  // namespace minksum::cli

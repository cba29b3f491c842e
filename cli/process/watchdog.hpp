// Keeps the time limits of single jobs.
#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "minksum/cancel.hpp"

namespace minksum::cli {

/// Cancels jobs that take too long. Many threads may use one; it starts a thread of its own once
/// that is needed.
class Watchdog {
 public:
  Watchdog() = default;
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Watches one job while it lives, and cancels the token when the time is over. Without a limit
  /// there is no token.
  class Watch {
   public:
    Watch(Watchdog& dog, double seconds);  ///< 0 = no limit
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    [[nodiscard]] const std::optional<CancelToken>& token() const { return token_; }

   private:
    using Clock = std::chrono::steady_clock;
    Watchdog& dog_;
    std::optional<CancelToken> token_;
    std::multimap<Clock::time_point, CancelToken>::iterator place_;
  };

 private:
  using Clock = std::chrono::steady_clock;
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::multimap<Clock::time_point, CancelToken> deadlines_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace minksum::cli

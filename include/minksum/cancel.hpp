// Stopping a running computation.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "minksum/export.h"

namespace minksum {

/// Asks a running computation to stop; may be used from any thread. Copies share one state.
///
/// What takes a token looks at it at least every 50 milliseconds of processor time, and then ends
/// with Error(kCancelled); docs/guarantees.md names the exceptions.
class MINKSUM_API CancelToken {
 public:
  CancelToken() : state_(std::make_shared<State>()) {}
  /// A token that asks `stop` whenever it is looked at, until that says true once: for hosts that
  /// must be asked, such as the interpreter of another language. It is called by the threads that
  /// compute; by several at a time where an operation has several. What it throws ends the
  /// operation and is thrown on.
  [[nodiscard]] static CancelToken polling(std::function<bool()> stop) {
    CancelToken token;
    token.state_->stop = std::move(stop);
    return token;
  }

  /// Asks to stop. That cannot be taken back.
  void cancel() const { state_->cancelled.store(true, std::memory_order_relaxed); }
  /// Whether somebody asked to stop. Asks the function of `polling`.
  [[nodiscard]] bool cancelled() const {
    if (state_->cancelled.load(std::memory_order_relaxed)) return true;
    if (!state_->stop || !state_->stop()) return false;
    cancel();
    return true;
  }

 private:
  struct State {
    std::atomic<bool> cancelled{false};
    std::function<bool()> stop;  ///< never changed once there are several threads
  };
  std::shared_ptr<State> state_;
};

}  // namespace minksum

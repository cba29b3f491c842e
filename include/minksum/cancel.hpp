// Declares the token that stops a running computation.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "minksum/export.h"

namespace minksum {

/// Asks a running computation to stop. Any thread may use it, and copies share one state.
///
/// An operation that has a token looks at it before it begins, and then at least every 50
/// milliseconds of processor time. Once the token is cancelled, the operation ends with
/// Error(kCancelled). docs/guarantees.md names the exceptions.
class MINKSUM_API CancelToken {
 public:
  CancelToken() : state_(std::make_shared<State>()) {}
  /// Copies share the state, and so does a token with what was moved from it.
  CancelToken(const CancelToken&) = default;
  CancelToken& operator=(const CancelToken&) = default;
  ~CancelToken() = default;
  /// Returns a token that asks `stop` whenever an operation looks at the token, until `stop`
  /// returns true once. It serves hosts that must be asked, such as the interpreter of another
  /// language. The computing threads call `stop`, several at a time if an operation has several.
  /// What `stop` throws ends the operation and is passed on.
  [[nodiscard]] static CancelToken polling(std::function<bool()> stop) {
    CancelToken token;
    token.state_->stop = std::move(stop);
    return token;
  }

  /// Asks the computation to stop. The request cannot be taken back.
  void cancel() const { state_->cancelled.store(true, std::memory_order_relaxed); }
  /// Tells whether somebody asked to stop. This calls the function of `polling`.
  [[nodiscard]] bool cancelled() const {
    if (state_->cancelled.load(std::memory_order_relaxed)) return true;
    if (!state_->stop || !state_->stop()) return false;
    cancel();
    return true;
  }

 private:
  struct State {
    std::atomic<bool> cancelled{false};
    std::function<bool()> stop;  ///< not changed once there are several threads
  };
  std::shared_ptr<State> state_;
};

}  // namespace minksum

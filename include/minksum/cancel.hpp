// Stopping a running computation.
#pragma once

#include <atomic>
#include <memory>

namespace minksum {

/// Asks a running computation to stop; may be used from any thread. Copies share one state.
class CancelToken {
 public:
  CancelToken() : cancelled_(std::make_shared<std::atomic<bool>>(false)) {}
  void cancel() const { cancelled_->store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const { return cancelled_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_;
};

}  // namespace minksum

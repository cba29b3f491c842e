// Progress of an operation that consists of many parts.
#pragma once

#include <atomic>
#include <cstddef>

#include "machine/cancellation.hpp"

namespace minksum {

/// The options of each part, whose progress is told as the progress of the whole. Any number of
/// threads may use it.
class PartProgress {
 public:
  /// `whole` must live as long.
  PartProgress(const Options& whole, std::size_t parts)
      : whole_(whole), parts_(parts), options_(part_of(whole)) {
    options_.threads = 1;  // threads share the parts
    options_.memory = nullptr;
    if (!whole.progress) return;
    options_.progress = [this](const Progress& part) {
      return whole_.progress({part.stage, done_.load(std::memory_order_relaxed), parts_});
    };
  }
  PartProgress(const PartProgress&) = delete;
  PartProgress& operator=(const PartProgress&) = delete;

  [[nodiscard]] const Options& options() const { return options_; }
  void finish_part() { done_.fetch_add(1, std::memory_order_relaxed); }

 private:
  const Options& whole_;
  std::size_t parts_;
  std::atomic<std::size_t> done_{0};
  Options options_;
};

}  // namespace minksum

// What the driver does around each stage's work.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "machine/cancellation.hpp"
#include "minksum/error.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum {

/// Asks before each stage whether to go on, times it and runs its checker if these are wanted. A
/// checker's time counts for the stage after it.
class StageRunner {
 public:
  explicit StageRunner(const Options& options) : options_(options), cancellation_(options) {
    if (options.statistics != nullptr) last_ = std::chrono::steady_clock::now();
  }

  template <class Work>
  void run(Stage stage, Work work) {
    cancellation_.enter(stage);
    work();
    // Readings of clocks would take a tenth of a sum of two polygons of 4 to 8 vertices.
    if (options_.statistics == nullptr) return;
    const std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
    options_.statistics->stage_seconds[static_cast<int>(stage)] +=
        std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  [[nodiscard]] Cancellation& cancellation() { return cancellation_; }
  void require(const std::optional<std::string>& fault) const {
    if (fault) throw Error(ErrorCode::kInternal, *fault, {}, to_string(cancellation_.stage()));
  }

 private:
  const Options& options_;
  Cancellation cancellation_;
  std::chrono::steady_clock::time_point last_;  ///< when the last stage ended
};

}  // namespace minksum

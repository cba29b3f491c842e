// The driver's frame around each stage: cancelling, timing and checking.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "machine/team.hpp"
#include "minksum/error.hpp"
#include "sum/sum_request.hpp"

namespace minksum {

/// Runs stages one by one. It looks for cancellation before each stage, and times each stage if
/// statistics are wanted. The time of a checker between two stages counts for the second one.
class StageRunner {
 public:
  explicit StageRunner(const SumRequest& options)
      : options_(options), team_(options.threads, options.share_all), cancellation_(options) {
    cancellation_.join(team_);
    if (options.statistics != nullptr) last_ = std::chrono::steady_clock::now();
  }

  template <class Work>
  void run(Stage stage, Work work) {
    cancellation_.enter(stage);
    work();
    // Reading the clock would take a tenth of the time of a sum of polygons of 4 to 8 vertices.
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
  const SumRequest& options_;
  Team team_;
  Cancellation cancellation_;
  std::chrono::steady_clock::time_point last_;  ///< when the last stage ended
};

}  // namespace minksum

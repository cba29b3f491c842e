// What batches of jobs and of pairs share: going on, running, counting, ending.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "batch.hpp"
#include "in_order.hpp"
#include "line_output.hpp"

namespace minksum::cli {

class BatchRun {
 public:
  explicit BatchRun(const BatchArguments& arguments);

  /// Takes what an earlier run has written. `next_head` gives how the next job's result begins;
  /// nothing if there are no more jobs. Throws a Failure if a line is not that job's result.
  void go_on(const std::function<std::optional<std::string>()>& next_head);
  /// Does the work, whose `consume` is this function's own; `share` tells how much is done, if that
  /// is known.
  void run(Work work, const std::function<std::optional<double>()>& share);
  /// Ends the output, writes statistics, of which some are given, and returns the exit code.
  [[nodiscard]] int finish(nlohmann::ordered_json more, OutputFiles& files);

  [[nodiscard]] std::uint64_t jobs() const { return jobs_; }

 private:
  const BatchArguments& arguments_;
  std::optional<LineOutput> output_;  ///< none = nothing is written
  std::uint64_t jobs_ = 0;
  std::uint64_t earlier_ = 0;  ///< of these, done by an earlier run
  std::uint64_t failed_ = 0;
  double seconds_ = 0;
};

}  // namespace minksum::cli

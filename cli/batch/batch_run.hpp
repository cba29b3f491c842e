// Does what batches of jobs and batches of pairs share: resuming, running, counting and ending.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "batch/in_order.hpp"
#include "commands/batch.hpp"
#include "output/json.hpp"
#include "output/line_output.hpp"

namespace minksum::cli {

class BatchRun {
 public:
  explicit BatchRun(const BatchArguments& arguments);

  /// The jobs as a sequence, for comparison with what an earlier run did.
  struct Jobs {
    /// Returns how the next job's result begins, or nothing after the last job.
    std::function<std::optional<std::string>()> head;
    std::function<void()> pass;  ///< passes over the next job, which is done
  };
  /// Takes over what an earlier run has written; with --restart, discards it. Throws a Failure, and
  /// changes nothing, if a line is not the result of its job. With --restart, any result passes.
  void go_on(const Jobs& jobs);
  /// Runs the tasks of `work` and writes their results, so `work.consume` must be empty. `share`
  /// returns which share of the work is done, if that is known.
  void run(Work work, const std::function<std::optional<double>()>& share);
  /// Ends the output, writes statistics with `more` among them, and returns the exit code.
  [[nodiscard]] int finish(const Json& more, OutputFiles& files);

  [[nodiscard]] std::uint64_t jobs() const { return jobs_; }

 private:
  void take_earlier(const Jobs& jobs);
  void check_earlier();
  [[noreturn]] void refuse(std::uint64_t line, std::string_view text) const;

  const BatchArguments& arguments_;
  std::optional<LineOutput> output_;  ///< none = results are not written
  std::uint64_t jobs_ = 0;
  std::uint64_t earlier_ = 0;  ///< jobs that an earlier run has done
  std::uint64_t failed_ = 0;
  double seconds_ = 0;
};

}  // namespace minksum::cli

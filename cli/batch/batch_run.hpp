// What batches of jobs and of pairs share: going on, running, counting, ending.
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

  /// The jobs, as far as an earlier run has done them.
  struct Jobs {
    /// How the next job's result begins; nothing if there are no more jobs.
    std::function<std::optional<std::string>()> head;
    std::function<void()> pass;  ///< the next job is done
  };
  /// Takes what an earlier run has written, or forgets it if that is asked for. Throws a Failure,
  /// and leaves everything as it was, if a line is not its job's result, or, to be forgotten, no
  /// result at all.
  void go_on(const Jobs& jobs);
  /// Does the work, whose `consume` is this function's own; `share` tells how much is done, if that
  /// is known.
  void run(Work work, const std::function<std::optional<double>()>& share);
  /// Ends the output, writes statistics, of which some are given, and returns the exit code.
  [[nodiscard]] int finish(const Json& more, OutputFiles& files);

  [[nodiscard]] std::uint64_t jobs() const { return jobs_; }

 private:
  void take_earlier(const Jobs& jobs);
  void check_earlier();
  [[noreturn]] void refuse(std::uint64_t line, std::string_view text) const;

  const BatchArguments& arguments_;
  std::optional<LineOutput> output_;  ///< none = nothing is written
  std::uint64_t jobs_ = 0;
  std::uint64_t earlier_ = 0;  ///< of these, done by an earlier run
  std::uint64_t failed_ = 0;
  double seconds_ = 0;
};

}  // namespace minksum::cli

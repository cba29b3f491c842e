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

/// Says where the results of a run go, and what does the work.
struct RunSettings {
  std::string output;  ///< empty = standard output
  std::string stats;   ///< empty = none
  int threads = 1;
  bool restart = false;
  bool no_output = false;
  const char* unit = "job";  ///< what is counted
  /// Takes the lines of results, which then go nowhere else.
  std::function<void(std::string_view lines)> sink;
};
[[nodiscard]] RunSettings settings_of(const BatchArguments& arguments);

/// Registers the output of results and of statistics. Throws a Failure.
void expect_files(const RunSettings& settings, OutputFiles& files);

class BatchRun {
 public:
  explicit BatchRun(RunSettings settings);

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
  /// Ends the output, writes statistics with `more` among them, and returns the exit code. With
  /// `deliver` the file of lines does not become the output: `deliver` writes that from the lines.
  [[nodiscard]] int finish(const Json& more, OutputFiles& files,
                           const std::function<void(LineOutput& lines)>& deliver = {});

  [[nodiscard]] std::uint64_t jobs() const { return jobs_; }

 private:
  void take_earlier(const Jobs& jobs);
  void check_earlier();
  [[noreturn]] void refuse(std::uint64_t line, std::string_view text) const;

  RunSettings settings_;
  std::optional<LineOutput> output_;  ///< none = results are not written to a file of lines
  std::uint64_t jobs_ = 0;
  std::uint64_t earlier_ = 0;  ///< jobs that an earlier run has done
  std::uint64_t failed_ = 0;
  double seconds_ = 0;
};

}  // namespace minksum::cli

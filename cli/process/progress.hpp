// Shows on a terminal how far a long run is.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace minksum::cli {

/// Returns a bar that is full to this share, from 0 to 1, and the share in per cent.
[[nodiscard]] std::string bar(double share);

/// The line at the end of standard error that changes as a run goes on.
class StatusLine {
 public:
  /// Lets lines be shown: on a terminal alone, or `always`.
  static void allow(bool always);
  /// Shows this line instead of the one before.
  static void show(const std::string& line);
  /// Removes the line, before something else is written. May be called by a signal handler.
  static void remove() noexcept;
  /// Shows no more lines if results appear on the same terminal from now on.
  static void make_way_for_results();
};

/// Counts the jobs of a batch, or what `unit` names, on the status line.
class BatchProgress {
 public:
  /// `beside_results` tells that results go to standard output.
  BatchProgress(const char* unit, bool beside_results);
  ~BatchProgress();  ///< removes the line
  BatchProgress(const BatchProgress&) = delete;
  BatchProgress& operator=(const BatchProgress&) = delete;
  /// Updates the line, at most ten times a second. `share` is the share of all work that is done,
  /// from 0 to 1, if known.
  void show(std::uint64_t jobs, std::uint64_t failed, std::optional<double> share);

 private:
  using Clock = std::chrono::steady_clock;
  const char* unit_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::optional<std::uint64_t> first_;  // jobs at the first call, done by an earlier run
};

}  // namespace minksum::cli

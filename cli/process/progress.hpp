// Shows on a terminal how far a long run is.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace minksum::cli {

/// Keeps one line on standard error up to date. Writes nothing if standard error is not a terminal,
/// or if results appear there, too.
class Progress {
 public:
  /// `beside_results` tells that results go to standard output.
  explicit Progress(bool beside_results);
  ~Progress();  ///< removes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Updates the line, at most ten times a second. `share` is the share of all work that is done,
  /// from 0 to 1, if known.
  void show(std::uint64_t jobs, std::uint64_t failed, std::optional<double> share);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::optional<std::uint64_t> first_;  // jobs at the first call, done by an earlier run
};

}  // namespace minksum::cli

// How far a long run is, for a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace minksum::cli {

/// A line on standard error that is written over and over; nothing if that is no terminal, or if
/// results are shown there, too.
class Progress {
 public:
  /// `beside_results`: these go to standard output.
  explicit Progress(bool beside_results);
  ~Progress();  ///< removes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// `share` of all work that is done, from 0 to 1, if that is known. At most ten times a second.
  void show(std::uint64_t jobs, std::uint64_t failed, std::optional<double> share);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::optional<std::uint64_t> first_;  // jobs at the first call: those are an earlier run's
};

}  // namespace minksum::cli

// Measures seconds.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

namespace minksum::bench {

/// Measures the time that this thread has had a processor. Other work on the machine makes that
/// longer only through caches and shared cores.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return now() - begin_; }

 private:
  static double now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double begin_ = now();
};

/// Makes so many results and returns the seconds that this takes. They are destroyed after the
/// clock was read, but for the last one, which is kept.
template <class Result, class Make>
double seconds_of(std::size_t times, Result& last, Make make) {
  std::vector<Result> results;
  results.reserve(times);
  const Stopwatch watch;
  while (results.size() < times) results.push_back(make());
  const double seconds = watch.seconds();
  last = std::move(results.back());
  return seconds;
}

/// Returns the least seconds of one call in a millisecond or more. `run(n)` returns the seconds of
/// n calls. Short calls are timed in blocks, because the clock itself takes half a microsecond.
template <class Run>
double least_seconds(Run run) {
  constexpr double kBlock = 50e-6;
  constexpr double kAll = 1e-3;
  std::size_t calls = 1;
  double seconds = run(calls);
  while (seconds < kBlock) seconds = run(calls *= 2);
  double least = seconds;
  for (double all = seconds; all < kAll; all += seconds) {
    seconds = run(calls);
    least = std::min(least, seconds);
  }
  return least / static_cast<double>(calls);
}

/// Measures wall-clock seconds, for work of several threads.
class WallStopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace minksum::bench

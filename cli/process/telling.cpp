#include "process/telling.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>

#include "output/statistics_json.hpp"
#include "process/failure.hpp"
#include "process/progress.hpp"

namespace minksum::cli {
namespace {

using Clock = std::chrono::steady_clock;

// Standard error is the process's own, and so is what the user wants to see there.
Telling wanted;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Several threads may report the progress of their parts at a time.
class Meter {
 public:
  void report(const minksum::Progress& progress) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    if (progress.parts < most_parts_) return;  // a part of what has parts
    most_parts_ = progress.parts;
    const double seconds = seconds_since(start_);
    const bool due = seconds_since(last_) >= 0.1;  // faster than anybody reads
    if (!due || (!wanted.progress && seconds < 1)) return;
    last_ = Clock::now();
    std::string line = std::to_string(static_cast<int>(std::floor(seconds))) + " s  ";
    if (progress.parts > 1) {
      const double share = static_cast<double>(progress.done) / static_cast<double>(progress.parts);
      line = bar(share) + line + std::to_string(progress.done) + " of " +
             std::to_string(progress.parts) + "  ";
    }
    StatusLine::show(line + to_string(progress.stage));
  }

 private:
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
  std::size_t most_parts_ = 1;
};

}  // namespace

void set_telling(const Telling& telling) { wanted = telling; }

void note(const std::string& message) {
  if (!wanted.quiet) tell(message);
}

void tell_detail(const std::string& message) {
  if (wanted.verbose) tell(message);
}

void tell_cost() {
  if (!wanted.verbose) return;
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  tell(readable_seconds(seconds(usage.ru_utime) + seconds(usage.ru_stime)) +
       " of processor time, " + std::to_string(usage.ru_maxrss / 1024) + " MB of memory");
}

std::function<bool(const minksum::Progress&)> live_progress() {
  if (wanted.quiet || !(wanted.progress || ::isatty(STDERR_FILENO) == 1)) return {};
  StatusLine::allow(wanted.progress);
  return [meter = std::make_shared<Meter>()](const minksum::Progress& progress) {
    meter->report(progress);
    return true;
  };
}

}  // namespace minksum::cli

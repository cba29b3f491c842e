#include "process/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "pictures/sum_picture.hpp"

namespace minksum::cli {

Progress::Progress(bool beside_results)
    : terminal_(::isatty(STDERR_FILENO) == 1 && !(beside_results && ::isatty(STDOUT_FILENO) == 1)) {
}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::uint64_t jobs, std::uint64_t failed, std::optional<double> share) {
  if (!terminal_) return;
  if (!first_) first_ = jobs;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  std::string line;
  if (share) {
    constexpr int kCells = 24;
    const double part = std::clamp(*share, 0.0, 1.0);
    const int full = static_cast<int>(part * kCells);
    line += '[';
    line.append(static_cast<std::size_t>(full), '#');
    line.append(static_cast<std::size_t>(kCells - full), ' ');
    line.append("] ").append(std::to_string(static_cast<int>(part * 100))).append(" %  ");
  }
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto rate = static_cast<std::uint64_t>(static_cast<double>(jobs - *first_) / seconds);
  line += grouped(jobs) + " jobs, " + grouped(failed) + " failed, " + grouped(rate) + " a second";
  std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
}

}  // namespace minksum::cli

#include "process/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>

#include "pictures/sum_picture.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

// The process has one standard error, and signal handlers reach static variables alone.
std::atomic<bool> allowed = false;
std::atomic<bool> shown = false;

void write_error(const char* text, std::size_t size) noexcept {
  const auto written = ::write(STDERR_FILENO, text, size);
  static_cast<void>(written);  // a line that cannot be shown is no failure
}

}  // namespace

std::string bar(double share) {
  constexpr int kCells = 24;
  const double part = std::clamp(share, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(part * kCells);
  return "[" + std::string(full, '#') + std::string(kCells - full, ' ') + "] " +
         std::to_string(static_cast<int>(part * 100)) + " %  ";
}

void StatusLine::allow(bool always) { allowed = always || ::isatty(STDERR_FILENO) == 1; }

void StatusLine::show(const std::string& line) {
  if (!allowed) return;
  const std::string text = "\r" + line + "\x1b[K";
  shown = true;
  write_error(text.data(), text.size());
}

void StatusLine::remove() noexcept {
  constexpr const char* kErase = "\r\x1b[K";
  if (shown.exchange(false)) write_error(kErase, std::strlen(kErase));
}

void StatusLine::make_way_for_results() {
  if (::isatty(STDOUT_FILENO) != 1) return;
  remove();
  allowed = false;
}

BatchProgress::BatchProgress(const char* unit, bool beside_results) : unit_(unit) {
  if (!live_progress()) return;
  if (beside_results) StatusLine::make_way_for_results();
}

BatchProgress::~BatchProgress() { StatusLine::remove(); }

void BatchProgress::show(std::uint64_t jobs, std::uint64_t failed, std::optional<double> share) {
  if (!first_) first_ = jobs;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto rate = static_cast<std::uint64_t>(static_cast<double>(jobs - *first_) / seconds);
  StatusLine::show((share ? bar(*share) : "") + grouped(jobs) + " " + unit_ + "s, " + grouped(failed) +
                   " failed, " + grouped(rate) + " a second");
}

}  // namespace minksum::cli

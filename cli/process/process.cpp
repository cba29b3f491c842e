#include "process/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "process/failure.hpp"
#include "process/progress.hpp"

namespace minksum::cli {
namespace {

// A signal handler can only reach static variables. One thread of the program writes files, and it
// alone takes signals; they are blocked while these variables change.
TemporaryFile* newest_file = nullptr;
char timeout_message[128] = "";
std::atomic<OutputState> output_state = OutputState::kNone;
static_assert(std::atomic<OutputState>::is_always_lock_free, "signal handlers use it");

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP};

void set_handler(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigfillset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void open_closed_streams() {
  // The stream is opened for the wrong direction, so that reading or writing still fails.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    const int opened = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (opened != stream && opened >= 0) ::close(opened);
  }
}

void write_error(const char* message) {
  StatusLine::remove();
  const auto written = ::write(STDERR_FILENO, message, std::strlen(message));
  static_cast<void>(written);  // a failure here cannot be reported
}

// By OutputState.
constexpr const char* kInterrupted[] = {
    "minksum: interrupted: no output was changed\n",
    "minksum: interrupted: what was printed is incomplete; no file was changed\n",
    "minksum: interrupted: FILE.partial keeps the jobs that are done; the same command continues\n",
    "minksum: interrupted: all files had been written\n"};

std::uint64_t number_in(const char* file) {
  std::uint64_t value = 0;
  std::ifstream(file) >> value;  // stays 0 for "max" and for a missing file
  return value;
}

}  // namespace
}  // namespace minksum::cli

// Handlers call only functions that POSIX allows in them.
extern "C" {

static void minksum_end_by_signal(int signal) {
  using namespace minksum::cli;
  TemporaryFile::remove_all();
  write_error(kInterrupted[static_cast<int>(output_state.load())]);
  ::raise(signal);  // acts by default once this handler returns
}

static void minksum_end_by_clock(int) {
  using namespace minksum::cli;
  TemporaryFile::remove_all();
  write_error(timeout_message);
  ::_exit(kLimitExceeded);
}

}  // extern "C"

namespace minksum::cli {

void prepare_process() {
  open_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : kEndingSignals) {
    if (!is_ignored(signal)) set_handler(signal, minksum_end_by_signal);
  }
}

void set_output_state(OutputState state) noexcept { output_state = state; }

void end_after(double seconds) {
  std::snprintf(timeout_message, sizeof timeout_message,
                "minksum: the time limit of %.6g seconds is exceeded (--timeout)\n", seconds);
  set_handler(SIGALRM, minksum_end_by_clock);
  itimerval timer{};
  const double whole = std::floor(seconds);
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  // The time is at least a microsecond, because 0 would stop the clock.
  timer.it_value.tv_usec = static_cast<suseconds_t>(
      std::clamp((seconds - whole) * 1e6, whole > 0 ? 0.0 : 1.0, 999'999.0));
  setitimer(ITIMER_REAL, &timer, nullptr);
}

bool limit_memory(std::uint64_t bytes) {
  // The stack grows now, because growing it once memory is used up would crash the program.
  constexpr std::size_t kStack = std::size_t{1} << 19;
  volatile char stack[kStack];
  for (std::size_t i = 0; i < kStack; i += 1024) stack[i] = 0;
  static_cast<void>(stack[0]);
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0) {
    if (limit.rlim_cur <= bytes) return false;
    limit.rlim_cur = bytes;
    if (setrlimit(RLIMIT_AS, &limit) == 0) return true;
  }
  throw Failure(kInternal, std::string("the memory cannot be limited: ") + std::strerror(errno));
}

std::uint64_t available_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return 0;
  std::uint64_t bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  for (const char* file :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    if (const std::uint64_t group = number_in(file); group > 0) bytes = std::min(bytes, group);
  }
  return bytes;
}

SignalsBlocked::SignalsBlocked() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before_);
}

SignalsBlocked::~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

TemporaryFile::TemporaryFile(const std::string& folder, const std::string& shown) {
  // The final name with an ending could be too long for the file system, so this name is short.
  constexpr const char* kEnding = ".tmp";
  name_ = folder + "/minksum-XXXXXX" + kEnding;
  const SignalsBlocked blocked;
  descriptor_ = ::mkstemps(name_.data(), static_cast<int>(std::strlen(kEnding)));
  if (descriptor_ < 0) {
    throw Failure(kBadInput, shown + ": cannot be written: " + std::strerror(errno));
  }
  older_ = newest_file;
  if (older_ != nullptr) older_->newer_ = this;
  newest_file = this;
}

TemporaryFile::~TemporaryFile() {
  const SignalsBlocked blocked;
  if (descriptor_ >= 0) ::close(descriptor_);
  if (name_.empty()) return;
  ::unlink(name_.c_str());
  forget();
}

void TemporaryFile::forget() {
  if (older_ != nullptr) older_->newer_ = newer_;
  (newer_ != nullptr ? newer_->older_ : newest_file) = older_;
  name_.clear();
}

int TemporaryFile::close() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  return ::close(descriptor) == 0 ? 0 : errno;
}

int TemporaryFile::move_to(const std::string& place) {
  const SignalsBlocked blocked;
  if (::rename(name_.c_str(), place.c_str()) != 0) return errno;
  forget();
  return 0;
}

void TemporaryFile::remove_all() noexcept {
  for (const TemporaryFile* file = newest_file; file != nullptr; file = file->older_) {
    ::unlink(file->name_.c_str());
  }
}

}  // namespace minksum::cli

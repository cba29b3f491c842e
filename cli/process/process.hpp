// What ends the process from outside: signals, the clock, the memory limit. No torn file is left.
#pragma once

#include <csignal>
#include <cstdint>
#include <string>

namespace minksum::cli {

/// Standard streams that are closed stay errors, instead of being the next file that is opened;
/// SIGINT, SIGTERM and SIGHUP (unless ignored) remove temporary files and then end the process
/// as they always do; a file that grows too large is an error of writing, not a signal.
void prepare_process();

/// Ends the process with exit code 3 after so many seconds, wherever it is: temporary files are
/// removed, and one line on standard error names the limit.
///
/// A signal handler does it, not a cancelled computation: reading and writing take no token, and
/// nothing of the process is needed after that.
void end_after(double seconds);

/// Makes requests for memory fail once the process has `bytes` of addresses. False if a lower limit
/// was there already, and stays. Throws a Failure if the system refuses.
[[nodiscard]] bool limit_memory(std::uint64_t bytes);
/// The memory of the machine, or of the control group if that has less; 0 = not known.
[[nodiscard]] std::uint64_t available_memory();

/// Holds all signals back, from this thread, for a few steps that belong together.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

/// A new, open file in `folder`, removed if the process ends before `move_to` or the destructor.
/// There may be several.
///
/// Only kill -9 and the loss of power leave it behind; its name says that it is temporary.
class TemporaryFile {
 public:
  /// Throws a Failure that names `shown`.
  TemporaryFile(const std::string& folder, const std::string& shown);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Nothing more is written. Returns 0 or the system's reason: some file systems tell only now
  /// that there was no room.
  [[nodiscard]] int close();
  /// Moves it to `place` in one step, after `close`. Returns 0 or the system's reason.
  [[nodiscard]] int move_to(const std::string& place);

  /// Removes all that there are; for signal handlers, after which nothing else happens.
  static void remove_all() noexcept;

 private:
  void forget();

  std::string name_;
  int descriptor_ = -1;
  TemporaryFile* older_ = nullptr;  // all that there are, in the order in which they were made
  TemporaryFile* newer_ = nullptr;
};

}  // namespace minksum::cli

// Handles what ends the process from outside: signals, the clock, the memory limit. No torn file is
// left behind.
#pragma once

#include <csignal>
#include <cstdint>
#include <string>

namespace minksum::cli {

/// Prepares the process for three events. Standard streams that are closed stay errors, and do not
/// become the next opened file. SIGINT, SIGTERM and SIGHUP (unless ignored) remove temporary files
/// before they end the process, and tell what has become of the output. A file that grows too large
/// is an error of writing, not a signal.
void prepare_process();

/// What a run has written so far, for the line that tells how a signal has ended it.
enum class OutputState {
  kNone,      ///< nothing that anybody sees
  kStream,    ///< a part of standard output
  kPartial,   ///< the partial file of a batch
  kComplete,  ///< all files
};
void set_output_state(OutputState state) noexcept;

/// Ends the process with exit code 3 after so many seconds, whatever it does then. Temporary files
/// are removed, and one line on standard error names the limit.
///
/// A signal handler does this instead of a cancel token, because reading and writing take no token
/// and the process ends anyway.
void end_after(double seconds);

/// Makes requests for memory fail once the process has `bytes` of addresses. Returns false if a
/// lower limit exists already, which then stays. Throws a Failure if the system refuses.
[[nodiscard]] bool limit_memory(std::uint64_t bytes);
/// Returns the memory of the machine, or of the control group if that has less; 0 = not known.
[[nodiscard]] std::uint64_t available_memory();

/// Blocks all signals for this thread while it lives, for a few steps that belong together.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

/// A new, open file in a folder. It is removed by the destructor, or when the process ends, unless
/// `move_to` has moved it. There may be several.
///
/// Only kill -9 or a loss of power leaves the file behind; its name says that it is temporary.
class TemporaryFile {
 public:
  /// Makes the file in `folder`. Throws a Failure that names `shown`.
  TemporaryFile(const std::string& folder, const std::string& shown);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Closes the file after all writing. Returns 0 or the system's reason, because some file systems
  /// report lack of room only now.
  [[nodiscard]] int close();
  /// Moves the closed file to `place` in one step. Returns 0 or the system's reason.
  [[nodiscard]] int move_to(const std::string& place);

  /// Removes all temporary files; for signal handlers, after which the process ends.
  static void remove_all() noexcept;

 private:
  void forget();

  std::string name_;
  int descriptor_ = -1;
  TemporaryFile* older_ = nullptr;  // links all such files by age
  TemporaryFile* newer_ = nullptr;
};

}  // namespace minksum::cli

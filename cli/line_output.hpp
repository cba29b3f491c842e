// Output line by line, with which a run that was interrupted can go on.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace minksum::cli {

/// Lines that go to standard output (an empty path), to a device, or to a file.
///
/// A file is written as `path`.partial and moved to its place by `finish`: until then the old file
/// stays. What a run leaves in `path`.partial when it is killed, even in the middle of a line, the
/// next one finds there. One run at a time: the file is locked.
class LineOutput {
 public:
  /// `restart`: forget what an earlier run has left. Throws a Failure with the system's reason.
  LineOutput(const std::string& path, bool restart);
  ~LineOutput();
  LineOutput(const LineOutput&) = delete;
  LineOutput& operator=(const LineOutput&) = delete;

  /// The next line that an earlier run wrote in full, without its end; nothing if there is no more.
  /// All are taken before anything is written.
  [[nodiscard]] std::optional<std::string> earlier_line();
  /// Appends text that ends with the end of a line.
  void write(std::string_view lines);
  /// Everything is written. Without this the file stays unfinished.
  void finish();
  /// Where a file stays until it is finished. Throws a Failure.
  [[nodiscard]] static std::string unfinished_place(const std::string& path);
  /// What messages call the unfinished file.
  [[nodiscard]] const std::string& unfinished() const { return shown_; }

 private:
  [[noreturn]] void fail(int reason) const;
  void open_file(const std::string& path, bool restart);

  std::string place_;  // where the finished file goes; empty = written as it is
  std::string partial_;
  std::string shown_ = "standard output";
  int descriptor_ = -1;
  bool reading_ = false;
  std::string buffer_;        // read and not yet taken
  std::size_t taken_ = 0;     // of the buffer
  std::size_t complete_ = 0;  // bytes of the file that are lines taken
};

}  // namespace minksum::cli

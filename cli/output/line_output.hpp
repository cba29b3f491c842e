// Writes results line by line, so that a run can resume after an interruption.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace minksum::cli {

/// Writes lines to standard output (an empty path), to a device, or to a file.
///
/// A file is written as `path`.partial, and `finish` moves it to its place; until then the old file
/// stays. A killed run leaves its output in `path`.partial, perhaps with a torn last line. The next
/// run may keep or discard that output. The file is locked, so only one run writes it at a time. If
/// that name belongs to a link, a pipe or a device, it is refused and left alone.
class LineOutput {
 public:
  /// Throws a Failure with the system's reason.
  explicit LineOutput(const std::string& path);
  ~LineOutput();
  LineOutput(const LineOutput&) = delete;
  LineOutput& operator=(const LineOutput&) = delete;

  /// Returns the next whole line of an earlier run, without its end, or nothing after the last one.
  /// All lines must be taken before anything is written.
  [[nodiscard]] std::optional<std::string> earlier_line();
  /// Returns the text behind the last whole line: a line that was torn.
  [[nodiscard]] const std::string& torn() const { return torn_; }
  /// Begins writing: behind the earlier lines if `keep` is true, else instead of them. The file
  /// does not change before this call.
  void begin(bool keep);
  /// Appends whole lines.
  void write(std::string_view lines);
  /// Moves the file to its place. Without this call the file stays unfinished.
  void finish();
  /// Goes back to the first line, so that `earlier_line` returns all lines of the file again.
  void rewind();
  /// Removes the unfinished file, whose lines are no longer needed.
  void discard();
  /// Returns the path at which a file is kept until it is finished. Throws a Failure.
  [[nodiscard]] static std::string unfinished_place(const std::string& path);
  /// Returns the name of the unfinished file for messages.
  [[nodiscard]] const std::string& unfinished() const { return shown_; }

 private:
  [[noreturn]] void fail(int reason) const;
  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void tell_other_run() const;
  void open_file(const std::string& path);

  std::string place_;  // path of the finished file; empty = written directly
  std::string partial_;
  std::string shown_ = "standard output";
  int descriptor_ = -1;
  bool reading_ = false;
  std::string buffer_;     // text that is read and not yet taken
  std::size_t taken_ = 0;  // characters of the buffer
  std::string torn_;
  std::size_t complete_ = 0;  // bytes of the lines that were taken
};

}  // namespace minksum::cli

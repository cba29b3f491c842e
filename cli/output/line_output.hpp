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
/// next one finds there, and may take up or forget. One run at a time: the file is locked. What is
/// no file, but a link, a pipe or a device, is refused and left alone.
class LineOutput {
 public:
  /// Throws a Failure with the system's reason.
  explicit LineOutput(const std::string& path);
  ~LineOutput();
  LineOutput(const LineOutput&) = delete;
  LineOutput& operator=(const LineOutput&) = delete;

  /// The next line that an earlier run wrote in full, without its end; nothing if there is no more.
  /// All are taken before anything is written.
  [[nodiscard]] std::optional<std::string> earlier_line();
  /// What stands behind the last of these lines, without an end: it was torn.
  [[nodiscard]] const std::string& torn() const { return torn_; }
  /// Writing begins: behind the earlier lines, or in place of everything that was there. Until then
  /// nothing is lost.
  void begin(bool keep);
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
  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void tell_other_run() const;
  void open_file(const std::string& path);

  std::string place_;  // where the finished file goes; empty = written as it is
  std::string partial_;
  std::string shown_ = "standard output";
  int descriptor_ = -1;
  bool reading_ = false;
  std::string buffer_;        // read and not yet taken
  std::size_t taken_ = 0;     // of the buffer
  std::string torn_;
  std::size_t complete_ = 0;  // bytes of the file that are lines taken
};

}  // namespace minksum::cli

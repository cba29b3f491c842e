// Writes output files so that no half file stays behind and no earlier file is lost.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "process/process.hpp"

namespace minksum::cli {

/// The output files of one run. Each is written beside its place, and all are moved to their places
/// once all are complete. Until then every old file stays.
class OutputFiles {
 public:
  /// Registers an output before any work is done. Messages call it `name`, such as "--svg". The
  /// path is that of a file, or is empty or "-" for standard output.
  ///
  /// Throws a Failure if the file probably cannot be written, so that nobody waits for a result in
  /// vain. Throws one for wrong usage if the same file was registered before, by whatever path, or
  /// if standard output or standard error goes to it. Devices and pipes may be registered twice,
  /// because they lose nothing.
  void expect(const std::string& name, const std::string& path);
  /// Registers an output whose name the program chose, in a folder that the user named. The user
  /// did not ask for a link, a device or a pipe of that name, so this throws a Failure for one.
  void expect_own(const std::string& name, const std::string& path);
  /// Does the same as `expect`, but ignores an empty path.
  void expect_if_any(const std::string& name, const std::string& path);
  /// Registers a file that no output may replace.
  void reserve(const std::string& name, const std::string& path);

  /// Lets `write` fill the file; devices, pipes and standard output are written directly. Throws a
  /// Failure with the system's reason.
  void write(const std::string& path, const std::function<void(std::ostream&)>& write);

  /// Moves all files to their places. Without this call no file is replaced.
  void finish();

 private:
  struct Written {
    Written(std::string path, std::filesystem::path at)
        : shown(std::move(path)), place(std::move(at)), file(place.parent_path().string(), shown) {}
    std::string shown;
    std::filesystem::path place;
    TemporaryFile file;
  };
  using Identity = std::pair<unsigned long long, unsigned long long>;  // device and inode

  void refuse_twice(const std::string& name, const std::string& path);

  std::map<std::filesystem::path, std::string> names_by_place_;
  std::map<Identity, std::string> names_by_identity_;
  std::set<std::string> own_;  // paths registered by `expect_own`
  std::deque<Written> written_;
};

/// Lets `write` fill standard output. Throws a Failure with the system's reason.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// Returns whether the path is that of anything but a regular file, such as a device or a pipe.
[[nodiscard]] bool is_special(const std::string& path);
/// Opens a device or pipe for writing, and returns the descriptor. Like any program, this waits for
/// the reader of a pipe. Throws a Failure, also if a regular file has taken that place meanwhile,
/// because it would not be replaced in one step.
[[nodiscard]] int open_special(const std::string& path);
/// Gives a new file the owner, group and permissions of the file at `place`, which it will replace.
/// Access control lists are included. Where the system refuses, nobody gains a right. Set-user-ID,
/// set-group-ID and sticky bits are not copied, because they were given to the old content. Without
/// an old file, permissions are those of any new file.
void take_over_rights(int descriptor, const std::filesystem::path& place);
/// Returns the path with all symbolic links resolved, because a rename would replace a link. Throws
/// a Failure.
[[nodiscard]] std::filesystem::path real_place(const std::string& path);

/// Makes the folder if it is missing. Throws a Failure.
void make_folder(const std::string& path);

}  // namespace minksum::cli

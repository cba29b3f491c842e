// Output that never leaves half a file behind, and never loses the file that was there before.
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

/// The output files of one run: each is written beside its place, and all are moved to their places
/// once all are complete. Until then every old file stays.
class OutputFiles {
 public:
  /// Takes note of an output, before anything is done; `name` is what messages call it: "--svg".
  /// The path is that of a file, or empty or "-" for standard output.
  ///
  /// Throws a Failure if it can hardly be written, so that nobody waits for a result that then has
  /// no place to go; and one for wrong usage if that file was noted already, by whatever path.
  /// Devices and pipes lose nothing when they are written twice.
  void expect(const std::string& name, const std::string& path);
  /// Takes note of an output whose name the program chose, in a folder that the user named. Nobody
  /// has said that a link, a device or a pipe of that name is meant: it is refused, with a Failure.
  void expect_own(const std::string& name, const std::string& path);
  /// The same as `expect` for an output that an empty path leaves out.
  void expect_if_any(const std::string& name, const std::string& path);
  /// Takes note of a file that no output may replace.
  void reserve(const std::string& name, const std::string& path);

  /// Lets `write` fill the file; devices, pipes and standard output are written as they are. Throws
  /// a Failure with the system's reason.
  void write(const std::string& path, const std::function<void(std::ostream&)>& write);

  /// Moves all files to their places. Without this nothing was replaced.
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
  std::set<std::string> own_;  // paths that `expect_own` was told of
  std::deque<Written> written_;
};

/// Lets `write` fill standard output. Throws a Failure with the system's reason.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// Whether the path is of something that has no "beside": a device, a pipe.
[[nodiscard]] bool is_special(const std::string& path);
/// Opens it for writing: a descriptor. Like any program, this waits for a pipe's reader. Throws a
/// Failure, also if a file has taken its place meanwhile, which would not be replaced in one step.
[[nodiscard]] int open_special(const std::string& path);
/// Gives a new file the owner, group and permissions (access control list included) of the file at
/// `place`, which it is to replace, as far as the system lets it; where it does not, nobody gets a
/// right that they had not. Set-user-ID, set-group-ID and sticky bits stay behind: they were given
/// to the old content. Where there is no such file, permissions are those of any new file.
void take_over_rights(int descriptor, const std::filesystem::path& place);
/// The file that the path stands for, without symbolic links: a rename would replace those. Throws
/// a Failure.
[[nodiscard]] std::filesystem::path real_place(const std::string& path);

/// Makes the folder if it is not there. Throws a Failure.
void make_folder(const std::string& path);

}  // namespace minksum::cli

#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "failure.hpp"

namespace minksum::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& what, int reason) {
  throw Failure(kBadInput, path + ": " + what + ": " + std::strerror(reason));
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Failure(kBadInput, path + ": " + what);
}

bool is_standard_output(const std::string& path) { return path.empty() || path == "-"; }

// A device or a pipe has no "beside".
bool is_special(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

// The file that a symbolic link stands for: a rename would replace the link itself.
fs::path real_place(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  if (error) fail(path, "cannot be written", error.value());
  return real;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void write_stream(std::ostream& out, const std::string& shown,
                  const std::function<void(std::ostream&)>& write) {
  errno = 0;
  write(out);
  out.flush();
  if (!out) fail(shown, "cannot be written", errno != 0 ? errno : EIO);
}

// The rights of the file that is replaced, or those that any new file gets.
mode_t rights_for(const fs::path& place) {
  struct stat status {};
  if (::stat(place.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

// A file beside `place`, there as long as it has not been moved to it.
class Beside {
 public:
  explicit Beside(const fs::path& place) : place_(place), name_(place.string() + ".XXXXXX") {
    const int file = ::mkstemp(name_.data());
    if (file < 0) fail(place.string(), "cannot be written", errno);
    ::fchmod(file, rights_for(place));
    ::close(file);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() {
    if (!moved_) ::unlink(name_.c_str());
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  void move_into_place() {
    if (::rename(name_.c_str(), place_.c_str()) != 0) {
      fail(place_.string(), "cannot be written", errno);
    }
    moved_ = true;
  }

 private:
  fs::path place_;
  std::string name_;
  bool moved_ = false;
};

}  // namespace

void check_writable(const std::string& path) {
  if (is_standard_output(path)) return;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail(path, "cannot be written", EISDIR);
  if (is_special(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail(path, "cannot be written", errno);
    return;
  }
  const fs::path folder = folder_of(real_place(path));
  if (!fs::is_directory(folder, ignored)) {
    fail(path, "cannot be written: there is no folder " + folder.string());
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, "cannot be written", errno);
  if (fs::exists(path, ignored) && ::access(path.c_str(), W_OK) != 0) {
    fail(path, "cannot be written", errno);
  }
}

void write_output(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (is_standard_output(path)) {
    write_stream(std::cout, "standard output", write);
    return;
  }
  check_writable(path);
  if (is_special(path)) {
    std::ofstream file(path, std::ios::binary);
    write_stream(file, path, write);
    return;
  }
  Beside beside(real_place(path));
  {
    std::ofstream file(beside.name(), std::ios::binary | std::ios::trunc);
    write_stream(file, path, write);
  }
  beside.move_into_place();
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, "cannot make this folder", error.value());
  if (!fs::is_directory(path, error)) fail(path, "is not a folder");
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail(path, "cannot be written", errno);
}

}  // namespace minksum::cli

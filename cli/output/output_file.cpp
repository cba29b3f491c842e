#include "output/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <streambuf>
#include <system_error>

#include "process/failure.hpp"
#include "process/process.hpp"
#include "process/progress.hpp"

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

// Writes to a file descriptor. Unlike a file stream, this needs no memory of the heap, and throws
// at the first failure, with the reason.
class DescriptorBuffer : public std::streambuf {
 public:
  DescriptorBuffer(int descriptor, const std::string& shown)
      : descriptor_(descriptor), shown_(shown) {
    setp(buffer_, buffer_ + sizeof buffer_);
  }

 protected:
  int_type overflow(int_type c) override {
    sync();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    if (size <= epptr() - pptr()) {
      std::memcpy(pptr(), text, static_cast<std::size_t>(size));
      pbump(static_cast<int>(size));
    } else {
      sync();
      write_all(text, static_cast<std::size_t>(size));
    }
    return size;
  }
  int sync() override {
    const auto size = static_cast<std::size_t>(pptr() - pbase());
    setp(buffer_, buffer_ + sizeof buffer_);
    write_all(buffer_, size);
    return 0;
  }

 private:
  void write_all(const char* text, std::size_t size) {
    while (size > 0) {
      const ssize_t written = ::write(descriptor_, text, size);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(shown_, "cannot be written", errno);
      text += written;
      size -= static_cast<std::size_t>(written);
    }
  }

  int descriptor_;
  const std::string& shown_;
  char buffer_[1 << 13];
};

void write_descriptor(int descriptor, const std::string& shown,
                      const std::function<void(std::ostream&)>& write) {
  DescriptorBuffer buffer(descriptor, shown);
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit);  // lets exceptions of the buffer pass the stream
  made_for(shown, [&] { write(out); });
  out.flush();
}

class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return descriptor_; }

 private:
  int descriptor_;
};

enum class AccessList { kNone, kTakenOver, kLost };

// With an access control list, the permission bits of the group are the maximum for all entries of
// the list. They mean nothing without the list.
AccessList take_over_access_list(int descriptor, const fs::path& place) {
  constexpr const char* kName = "system.posix_acl_access";
  const ssize_t size = ::getxattr(place.c_str(), kName, nullptr, 0);
  if (size <= 0) return AccessList::kNone;
  std::string list(static_cast<std::size_t>(size), '\0');
  const bool taken = ::getxattr(place.c_str(), kName, list.data(), list.size()) == size &&
                     ::fsetxattr(descriptor, kName, list.data(), list.size(), 0) == 0;
  return taken ? AccessList::kTakenOver : AccessList::kLost;
}

// Fills the status of the file at the path; returns whether there is one.
bool find(const fs::path& path, struct stat& status) { return ::stat(path.c_str(), &status) == 0; }

void check_writable(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail(path, "cannot be written", EISDIR);
  if (is_special(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail(path, "cannot be written", errno);
    return;
  }
  const fs::path folder = real_place(path).parent_path();
  if (!fs::is_directory(folder, ignored)) {
    fail(path, "cannot be written: there is no folder " + folder.string());
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, "cannot be written", errno);
  if (fs::exists(path, ignored) && ::access(path.c_str(), W_OK) != 0) {
    fail(path, "cannot be written", errno);
  }
}

}  // namespace

void take_over_rights(int descriptor, const fs::path& place) {
  struct stat old {};
  if (!find(place, old)) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(descriptor, 0666 & ~mask);
    return;
  }
  constexpr auto kSameOwner = static_cast<uid_t>(-1);
  const bool same_group = ::fchown(descriptor, old.st_uid, old.st_gid) == 0 ||
                          ::fchown(descriptor, kSameOwner, old.st_gid) == 0;
  const AccessList list = same_group ? take_over_access_list(descriptor, place) : AccessList::kLost;
  if (list == AccessList::kTakenOver) return;  // the list brought the permission bits
  mode_t rights = old.st_mode & 0777;
  if (list == AccessList::kLost) rights &= 0707 | ((rights & 07) << 3);
  ::fchmod(descriptor, rights);
}

int open_special(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) fail(path, "cannot be written", errno);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || S_ISREG(status.st_mode)) {
    ::close(descriptor);
    fail(path, "cannot be written: another program has just put a file there");
  }
  return descriptor;
}

bool is_special(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

fs::path real_place(const std::string& path) {
  constexpr int kMostLinks = 40;  // the limit of the system
  std::error_code error;
  fs::path at = path;
  // `weakly_canonical` would take a link to a missing file for a missing file.
  for (int links = 0; links < kMostLinks && fs::is_symlink(at, error); ++links) {
    at = at.parent_path() / fs::read_symlink(at, error);
  }
  const fs::path real = fs::weakly_canonical(fs::absolute(at, error), error);
  if (error) fail(path, "cannot be written", error.value());
  return real;
}

void OutputFiles::refuse_twice(const std::string& name, const std::string& path) {
  if (is_standard_output(path)) return;
  const auto refuse = [&](const std::string& other) {
    throw Failure(kWrongUsage, other + " and " + name + " are the same file: " + path);
  };
  struct stat status {};
  const bool there = find(path, status);
  if (there && !S_ISREG(status.st_mode)) return;
  const auto [known, added] = names_by_place_.emplace(real_place(path), name);
  if (!added) refuse(known->second);
  if (!there) return;
  // Such a file would be replaced, with all that others have written or go on writing to it.
  for (const auto& [descriptor, stream] :
       {std::pair{STDOUT_FILENO, "standard output"}, std::pair{STDERR_FILENO, "standard error"}}) {
    struct stat open {};
    if (::fstat(descriptor, &open) == 0 && open.st_dev == status.st_dev &&
        open.st_ino == status.st_ino) {
      throw Failure(kWrongUsage, name + " is the file that " + stream + " goes to: " + path +
                                     "; name another file");
    }
  }
  const auto [other, is_new] =
      names_by_identity_.emplace(Identity{status.st_dev, status.st_ino}, name);
  if (!is_new) refuse(other->second);
}

void OutputFiles::expect(const std::string& name, const std::string& path) {
  refuse_twice(name, path);
  if (!is_standard_output(path)) check_writable(path);
}

void OutputFiles::expect_own(const std::string& name, const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    fail(path, "is not a file, but a file of this name is to be written (" + name +
                   "): move it away, or name another folder");
  }
  expect(name, path);
  own_.insert(path);
}

void OutputFiles::expect_if_any(const std::string& name, const std::string& path) {
  if (!path.empty()) expect(name, path);
}

void OutputFiles::reserve(const std::string& name, const std::string& path) {
  refuse_twice(name, path);
}

void OutputFiles::write(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (is_standard_output(path)) return write_standard_output(write);
  const bool own = own_.contains(path);
  if (!own && is_special(path)) {
    const Descriptor file(open_special(path));
    return write_descriptor(file.get(), path, write);
  }
  const fs::path place =
      own ? real_place(fs::path(path).parent_path()) / fs::path(path).filename() : real_place(path);
  TemporaryFile& file = written_.emplace_back(path, place).file;
  write_descriptor(file.descriptor(), path, write);
  take_over_rights(file.descriptor(), place);
  // Without this, a loss of power soon after could leave an empty file in the old one's place. If a
  // file system lacks this call (EINVAL, ENOTSUP), nothing better is possible.
  if (::fsync(file.descriptor()) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) {
    fail(path, "cannot be written", errno);
  }
  if (const int reason = file.close()) fail(path, "cannot be written", reason);
}

void OutputFiles::finish() {
  const SignalsBlocked blocked;
  for (Written& written : written_) {
    const int reason = written.file.move_to(written.place.string());
    if (reason != 0) fail(written.shown, "cannot be written", reason);
  }
  if (!written_.empty()) set_output_state(OutputState::kComplete);
  written_.clear();
}

void write_standard_output(const std::function<void(std::ostream&)>& write) {
  StatusLine::make_way_for_results();
  set_output_state(OutputState::kStream);
  write_descriptor(STDOUT_FILENO, "standard output", write);
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, "cannot make this folder", error.value());
  if (!fs::is_directory(path, error)) fail(path, "is not a folder");
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail(path, "cannot be written", errno);
}

}  // namespace minksum::cli

#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <streambuf>
#include <system_error>

#include "failure.hpp"
#include "process.hpp"

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

// Writes to a file descriptor. Unlike a file stream's, its buffer needs no memory of the heap, and
// the first failure is thrown, with its reason.
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
  out.exceptions(std::ios::badbit);  // so that what is thrown below passes through the stream
  write(out);
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

// The rights of the file that is replaced, or those that any new file gets.
mode_t rights_for(const fs::path& place) {
  struct stat status {};
  if (::stat(place.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  const fs::path place = real_place(path);
  TemporaryFile file(folder_of(place).string(), path);
  write_descriptor(file.descriptor(), path, write);
  ::fchmod(file.descriptor(), rights_for(place));
  // Without this, the loss of power soon after could leave an empty file in the old one's place.
  // Where a file system cannot do it (EINVAL, ENOTSUP), there is nothing to wait for.
  if (::fsync(file.descriptor()) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) {
    fail(path, "cannot be written", errno);
  }
  if (const int reason = file.move_to(place.string())) fail(path, "cannot be written", reason);
}

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
  if (is_standard_output(path)) return write_descriptor(STDOUT_FILENO, "standard output", write);
  check_writable(path);
  if (!is_special(path)) return write_file(path, write);
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_NOCTTY));
  if (file.get() < 0) fail(path, "cannot be written", errno);
  write_descriptor(file.get(), path, write);
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, "cannot make this folder", error.value());
  if (!fs::is_directory(path, error)) fail(path, "is not a folder");
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail(path, "cannot be written", errno);
}

}  // namespace minksum::cli

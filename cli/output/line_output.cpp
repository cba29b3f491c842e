#include "output/line_output.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "output/output_file.hpp"
#include "process/failure.hpp"
#include "process/process.hpp"

namespace minksum::cli {

namespace {

// Returns whether the name is that of the descriptor's file itself, and not of a link to it.
bool is_at(const std::string& name, int descriptor) {
  struct stat named {};
  struct stat opened {};
  return ::lstat(name.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
         named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

}  // namespace

LineOutput::LineOutput(const std::string& path) {
  if (path.empty()) {
    set_output_state(OutputState::kStream);
    descriptor_ = STDOUT_FILENO;
    return;
  }
  shown_ = path;
  if (is_special(path)) {
    descriptor_ = open_special(path);
  } else {
    open_file(path);
  }
}

void LineOutput::open_file(const std::string& path) {
  place_ = real_place(path).string();
  partial_ = unfinished_place(path);
  std::error_code ignored;
  shown_ = std::filesystem::is_symlink(path, ignored) ? partial_ : path + ".partial";
  // Anything may have that name already, so no link is followed, and opening never waits for the
  // other end of a pipe. Until the file is moved to its place, only the owner can read it.
  constexpr int kFlags = O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY;
  descriptor_ = ::open(partial_.c_str(), kFlags, 0600);
  const int reason = errno;
  struct stat status {};
  const bool there = descriptor_ < 0 ? ::lstat(partial_.c_str(), &status) == 0
                                     : ::fstat(descriptor_, &status) == 0;
  if (there && !S_ISREG(status.st_mode)) refuse("is no file, but a link, a folder, or a device");
  if (descriptor_ < 0) fail(reason);
  if (status.st_nlink > 1) refuse("has another name as well, a hard link");
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) tell_other_run();
  // Another run may have moved the file to its place before the lock was free.
  if (!is_at(partial_, descriptor_)) tell_other_run();
  reading_ = true;
}

std::string LineOutput::unfinished_place(const std::string& path) {
  return real_place(path).string() + ".partial";
}

LineOutput::~LineOutput() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

void LineOutput::refuse(const std::string& why) const {
  throw Failure(kBadInput, shown_ + ": " + why +
                               ": not what a run of these jobs has left; move it away, or name "
                               "another file with -o");
}

void LineOutput::tell_other_run() const {
  throw Failure(kBadInput, shown_ + ": another run is writing it");
}

void LineOutput::fail(int reason) const {
  throw Failure(kBadInput, shown_ + ": cannot be written: " + std::strerror(reason));
}

std::optional<std::string> LineOutput::earlier_line() {
  if (!reading_) return {};
  std::size_t searched = taken_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = buffer_.substr(taken_, end - taken_);
      complete_ += line.size() + 1;
      taken_ = end + 1;
      return line;
    }
    buffer_.erase(0, taken_);
    taken_ = 0;
    searched = buffer_.size();
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    buffer_.resize(searched + kChunk);
    ssize_t got = 0;
    do {
      got = ::read(descriptor_, buffer_.data() + searched, kChunk);
    } while (got < 0 && errno == EINTR);
    if (got < 0) fail(errno);
    buffer_.resize(searched + static_cast<std::size_t>(got));
    if (got == 0) break;
  }
  reading_ = false;
  torn_ = std::exchange(buffer_, {});
  return {};
}

void LineOutput::begin(bool keep) {
  if (place_.empty()) return;
  set_output_state(OutputState::kPartial);
  if (::ftruncate(descriptor_, keep ? static_cast<off_t>(complete_) : 0) != 0 ||
      ::lseek(descriptor_, 0, SEEK_END) < 0) {
    fail(errno);
  }
}

void LineOutput::write(std::string_view lines) {
  while (!lines.empty()) {
    const ssize_t written = ::write(descriptor_, lines.data(), lines.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    lines.remove_prefix(static_cast<std::size_t>(written));
  }
}

void LineOutput::finish() {
  if (place_.empty()) return;
  if (::fsync(descriptor_) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT)) {
    fail(errno);
  }
  if (!is_at(partial_, descriptor_)) refuse("is another file than the one that was written");
  take_over_rights(descriptor_, place_);
  if (::rename(partial_.c_str(), place_.c_str()) != 0) fail(errno);
}

void LineOutput::rewind() {
  if (::lseek(descriptor_, 0, SEEK_SET) < 0) fail(errno);
  buffer_.clear();
  taken_ = 0;
  reading_ = true;
}

void LineOutput::discard() {
  if (!place_.empty() && is_at(partial_, descriptor_)) ::unlink(partial_.c_str());
}

}  // namespace minksum::cli

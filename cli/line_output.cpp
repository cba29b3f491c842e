#include "line_output.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "failure.hpp"
#include "output_file.hpp"

namespace minksum::cli {

LineOutput::LineOutput(const std::string& path, bool restart) {
  if (path.empty()) {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  shown_ = path;
  if (is_special(path)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
  } else {
    open_file(path, restart);
  }
}

void LineOutput::open_file(const std::string& path, bool restart) {
  place_ = real_place(path).string();
  partial_ = unfinished_place(path);
  shown_ = path + ".partial";
  descriptor_ = ::open(partial_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw Failure(kBadInput, shown_ + ": another run is writing it");
  }
  if (restart && ::ftruncate(descriptor_, 0) != 0) fail(errno);
  reading_ = true;
}

std::string LineOutput::unfinished_place(const std::string& path) {
  return real_place(path).string() + ".partial";
}

LineOutput::~LineOutput() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
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
  buffer_ = {};
  // A line without an end was torn.
  if (::ftruncate(descriptor_, static_cast<off_t>(complete_)) != 0 ||
      ::lseek(descriptor_, 0, SEEK_END) < 0) {
    fail(errno);
  }
  return {};
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
  if (::rename(partial_.c_str(), place_.c_str()) != 0) fail(errno);
}

}  // namespace minksum::cli

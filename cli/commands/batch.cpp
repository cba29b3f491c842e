// minksum batch: runs many operations on all cores, with results in order.
#include "commands/batch.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <ostream>
#include <utility>

#include "batch/batch_job.hpp"
#include "batch/batch_run.hpp"
#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "options/unused_options.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

// Reads the lines of a file of jobs as they are needed, and passes over empty ones.
class JobLines {
 public:
  JobLines(const std::string& file, std::size_t max_bytes)
      : shown_(shown_name(file)), max_bytes_(max_bytes) {
    descriptor_ = file == "-" ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    struct stat status {};
    if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
      size_ = static_cast<std::uint64_t>(status.st_size);
    }
  }
  ~JobLines() {
    if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  }
  JobLines(const JobLines&) = delete;
  JobLines& operator=(const JobLines&) = delete;

  std::optional<JobLine> next() {
    if (ahead_) return std::exchange(ahead_, {});
    for (;;) {
      std::optional<JobLine> line = take();
      if (!line) return {};
      if (line->number == 1 && line->text.starts_with("\xef\xbb\xbf")) line->text.erase(0, 3);
      if (line->text.ends_with('\r')) line->text.pop_back();
      if (line->text.find_first_not_of(" \t") != std::string::npos) return line;
    }
  }
  // Returns the next line without taking it; nullptr if there is none.
  const JobLine* peek() {
    if (!ahead_) ahead_ = next();
    return ahead_ ? &*ahead_ : nullptr;
  }
  // Returns whether the next line, or the end, can be read without waiting for its writer.
  [[nodiscard]] bool are_at_hand() const {
    if (ahead_ || buffer_.find('\n', at_) != std::string::npos) return true;
    pollfd poll{descriptor_, POLLIN, 0};
    return ::poll(&poll, 1, 0) != 0;
  }
  // Returns the share of the file's bytes that has been read; nothing for a pipe.
  [[nodiscard]] std::optional<double> share() const {
    if (size_ == 0) return {};
    return static_cast<double>(read_) / static_cast<double>(size_);
  }

 private:
  [[noreturn]] void fail(int reason) const {
    throw Failure(kBadInput, shown_ + ": cannot be read: " + std::strerror(reason));
  }
  bool refill() {
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    buffer_.resize(kChunk);
    ssize_t got = 0;
    do {
      got = ::read(descriptor_, buffer_.data(), kChunk);
    } while (got < 0 && errno == EINTR);
    if (got < 0) fail(errno);
    buffer_.resize(static_cast<std::size_t>(got));
    at_ = 0;
    read_ += static_cast<std::uint64_t>(got);
    return got > 0;
  }
  std::optional<JobLine> take() {
    JobLine line;
    bool any = false;
    for (;;) {
      if (at_ == buffer_.size() && !refill()) break;
      any = true;
      const std::size_t end = std::min(buffer_.find('\n', at_), buffer_.size());
      const std::size_t part = end - at_;
      const std::size_t kept = std::min(part, max_bytes_ - line.text.size());
      line.text.append(buffer_, at_, kept);
      line.dropped += part - kept;
      at_ = end;
      if (end == buffer_.size()) continue;
      ++at_;
      break;
    }
    if (!any) return {};
    line.number = ++number_;
    return line;
  }

  std::string shown_;
  std::optional<JobLine> ahead_;
  std::size_t max_bytes_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t read_ = 0;
  std::uint64_t number_ = 0;
  std::string buffer_;
  std::size_t at_ = 0;
};

}  // namespace

int run_batch(const BatchArguments& arguments) {
  if (!arguments.pairs.empty()) return run_pairs(arguments);
  OutputFiles files;
  expect_files(arguments, files);
  JobLines lines(arguments.jobs, arguments.limits.read.max_bytes);
  JobRunner runner(arguments);
  BatchRun run(settings_of(arguments));
  run.go_on({[&]() -> std::optional<std::string> {
               const JobLine* const line = lines.peek();
               return line != nullptr ? std::optional(runner.head(*line)) : std::nullopt;
             },
             [&] {
               static_cast<void>(lines.next());
               mark_all_taken();
               for (const OptionText& option : arguments.defaults) *option.is_taken = true;
             }});
  Work work;
  work.next = [&]() -> std::optional<Task> {
    std::optional<JobLine> line = lines.next();
    if (!line) return {};
    const std::size_t bytes = line->text.size();
    return Task{
        [&runner, line = std::move(*line)](Worker& worker) { return runner.run(line, worker); },
        bytes};
  };
  work.is_at_hand = [&] { return lines.are_at_hand(); };
  run.run(std::move(work), [&] { return lines.share(); });
  for (const OptionText& option : arguments.defaults) {
    if (!*option.is_taken) note("--" + option.name + " has no effect: no job takes it");
  }
  return run.finish(Json::object(), files);
}

void add_batch(Program& program) { program.add(describe_batch, run_batch); }

}  // namespace minksum::cli

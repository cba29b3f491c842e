#include "child.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <new>
#include <stdexcept>

namespace minksum::bench {
namespace {

void write_all(int file, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = ::write(file, text.data() + written, text.size() - written);
    if (count <= 0) return;
    written += static_cast<std::size_t>(count);
  }
}

std::string to_text(const Json& members) {
  return members.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void limit_address_space(std::size_t bytes) {
  const rlimit limit{bytes, bytes};
  (void)::setrlimit(RLIMIT_AS, &limit);
}

[[noreturn]] void be_child(int out, const ChildLimits& limits,
                           const std::function<void(const Report&)>& work) {
  limit_address_space(limits.address_space_bytes);
  const Report report = [out](const Json& members) { write_all(out, to_text(members) + "\n"); };
  std::string status = "ok";
  try {
    work(report);
  } catch (const std::bad_alloc&) {
    status = "over memory";
  } catch (const std::exception& error) {
    status = error.what();
  }
  report({{"status", status}});
  ::_exit(0);
}

void take_lines(std::string& text, ChildEnd& end) {
  for (std::size_t line_end = text.find('\n'); line_end != std::string::npos;
       line_end = text.find('\n')) {
    const Json members = Json::parse(text.substr(0, line_end));
    if (members.contains("status")) {
      end.status = members["status"];
    } else {
      end.members.update(members);
    }
    text.erase(0, line_end + 1);
  }
}

// Reads until the child closes its end; returns false if the child was silent for too long.
bool listen(int in, double longest_silence, ChildEnd& end) {
  std::string text;
  char buffer[1U << 14U];
  for (;;) {
    pollfd waiting{in, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(longest_silence * 1000));
    if (ready == 0) return false;
    const ssize_t count = ::read(in, buffer, sizeof buffer);
    if (count <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(count));
    take_lines(text, end);
  }
}

}  // namespace

ChildEnd run_in_child(const ChildLimits& limits, const std::function<void(const Report&)>& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    ::close(ends[0]);
    be_child(ends[1], limits, work);
  }
  ::close(ends[1]);
  ChildEnd end;
  const bool in_time = listen(ends[0], limits.seconds_between_reports, end);
  ::close(ends[0]);
  if (!in_time) ::kill(child, SIGKILL);
  int state = 0;
  (void)::waitpid(child, &state, 0);
  if (!in_time) {
    end.status = "over time";
  } else if (end.status.empty()) {
    end.status = "crashed";
  }
  return end;
}

std::size_t restart_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::size_t peak_memory() {
  rusage usage{};
  (void)::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace minksum::bench

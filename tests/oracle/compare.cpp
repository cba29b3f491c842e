#include "oracle/compare.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <exception>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "minksum/minkowski_sum.hpp"
#include "oracle/cgal_oracle.hpp"
#include "reference/membership.hpp"

namespace minksum::oracle {
namespace {

using reference::Loop;
using reference::Loops;
using reference::Number;
using reference::Pt;
using reference::Side;

constexpr std::array kVerdicts{
    std::pair{Verdict::kEqual, "equal"},
    std::pair{Verdict::kCgalWrong, "CGAL wrong"},
    std::pair{Verdict::kMinksumWrong, "minksum wrong"},
    std::pair{Verdict::kUnexplained, "unexplained"},
    std::pair{Verdict::kMinksumFailed, "minksum failed"},
    std::pair{Verdict::kCgalFailed, "CGAL failed"},
    std::pair{Verdict::kCgalTimeout, "CGAL timeout"},
};

constexpr std::size_t kMaxProofs = 6;
[[maybe_unused]] constexpr rlim_t kMaxMemory = rlim_t{9} << 30U;  // two children fit 24 GiB

Loops all_rings(const Region& region) {
  Loops rings;
  for (const Loops& polygon : reference::to_loops(region)) {
    rings.insert(rings.end(), polygon.begin(), polygon.end());
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

// Returns points at which the two sums may differ: inside a ring and beside its edges.
std::vector<Pt> candidates(const Loop& ring) {
  std::vector<Pt> points{reference::point_strictly_inside({ring})};
  const Number close(1, 1 << 20);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Pt& a = ring[i];
    const Pt& b = ring[(i + 1) % ring.size()];
    const Pt m = reference::midpoint(a, b);
    const Number nx = (b.y - a.y) * close;
    const Number ny = (a.x - b.x) * close;
    points.push_back({Number(m.x + nx), Number(m.y + ny)});
    points.push_back({Number(m.x - nx), Number(m.y - ny)});
  }
  return points;
}

std::string show(const Pt& p) {
  std::ostringstream out;
  out << '(' << p.x << ' ' << p.y << ')';
  return out.str();
}

}  // namespace

const char* to_string(Verdict verdict) {
  for (const auto& [value, text] : kVerdicts) {
    if (value == verdict) return text;
  }
  return "?";
}

std::optional<Verdict> parse_verdict(const std::string& text) {
  for (const auto& [value, name] : kVerdicts) {
    if (text == name) return value;
  }
  return std::nullopt;
}

bool is_failure(Verdict verdict) {
  return verdict == Verdict::kMinksumWrong || verdict == Verdict::kUnexplained ||
         verdict == Verdict::kMinksumFailed;
}

Comparison explain(const Region& p, const Region& q, const Region& ours, const Region& theirs) {
  const Loops our_rings = all_rings(ours);
  const Loops their_rings = all_rings(theirs);
  Loops differing;
  std::set_symmetric_difference(our_rings.begin(), our_rings.end(), their_rings.begin(),
                                their_rings.end(), std::back_inserter(differing));
  Comparison result;
  std::ostringstream detail;
  detail << differing.size() << " rings differ (" << our_rings.size() << " ours, "
         << their_rings.size() << " CGAL's)";
  std::size_t proofs = 0;
  for (std::size_t r = 0; r < differing.size() && proofs < kMaxProofs; ++r) {
    for (const Pt& point : candidates(differing[r])) {
      const bool we_say = reference::locate(point, ours) != Side::kOutside;
      const bool they_say = reference::locate(point, theirs) != Side::kOutside;
      if (we_say == they_say) continue;
      const bool truth = reference::contains_sum(p, q, point);
      detail << "; " << show(point) << (truth ? " is in the sum, " : " is not in the sum, ")
             << (truth == we_say ? "CGAL" : "minksum") << " is wrong";
      if (truth != we_say) {
        result.verdict = Verdict::kMinksumWrong;
      } else if (result.verdict == Verdict::kUnexplained) {
        result.verdict = Verdict::kCgalWrong;
      }
      ++proofs;
      break;
    }
  }
  result.detail = detail.str();
  return result;
}

namespace {

// Writes a child's report as lines "key value", each flushed at once, so that a crash loses none.
class Teller {
 public:
  explicit Teller(int pipe) : pipe_(pipe) {}
  template <class T>
  void operator()(const char* key, const T& value) const {
    std::ostringstream out;
    out << key << ' ' << value << '\n';
    const std::string line = out.str();
    for (std::size_t done = 0; done < line.size();) {
      const ssize_t n = write(pipe_, line.data() + done, line.size() - done);
      if (n <= 0) _exit(1);
      done += static_cast<std::size_t>(n);
    }
  }

 private:
  int pipe_;
};

void limit_processor_time(int seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

// A sanitizer reserves terabytes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MINKSUM_UNDER_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MINKSUM_UNDER_SANITIZER
#endif
#endif

void limit_memory() {
#ifndef MINKSUM_UNDER_SANITIZER
  const rlimit memory{kMaxMemory, kMaxMemory};
  setrlimit(RLIMIT_AS, &memory);
#endif
}

void run_child(const Region& p, const Region& q, int cgal_limit, const Teller& tell) {
  limit_memory();
  Region ours;
  try {
    const auto start = std::chrono::steady_clock::now();
    ours = minkowski_sum(p, q);
    tell("minksum_seconds",
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    tell("vertices", ours.vertex_count());
    tell("holes", ours.hole_count());
  } catch (const std::exception& error) {
    tell("detail", error.what());
    return tell("verdict", to_string(Verdict::kMinksumFailed));
  }
  CgalSum theirs;
  tell("phase", "CGAL");
  limit_processor_time(cgal_limit);
  try {
    theirs = cgal_sum(p, q);
  } catch (const std::exception& error) {
    limit_processor_time(0);
    tell("detail", error.what());
    return tell("verdict", to_string(Verdict::kCgalFailed));
  }
  limit_processor_time(0);
  tell("cgal_seconds", theirs.seconds);
  tell("phase", "comparison");
  if (ours == theirs.sum) return tell("verdict", to_string(Verdict::kEqual));
  const Comparison reason = explain(p, q, ours, theirs.sum);
  tell("detail", reason.detail);
  tell("verdict", to_string(reason.verdict));
}

Comparison understand(const std::string& said, int status) {
  std::map<std::string, std::string> values;
  std::istringstream in(said);
  for (std::string line; std::getline(in, line);) {
    const std::size_t space = line.find(' ');
    if (space != std::string::npos) values[line.substr(0, space)] = line.substr(space + 1);
  }
  const auto number = [&values](const char* key) {
    return values.contains(key) ? std::stod(values[key]) : 0.0;
  };
  Comparison result;
  result.minksum_seconds = number("minksum_seconds");
  result.cgal_seconds = number("cgal_seconds");
  result.vertices = static_cast<std::size_t>(number("vertices"));
  result.holes = static_cast<std::size_t>(number("holes"));
  result.detail = values["detail"];
  if (const auto verdict = parse_verdict(values["verdict"])) {
    result.verdict = *verdict;
  } else if (values["phase"] == "CGAL") {
    const bool is_timeout = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
    result.verdict = is_timeout ? Verdict::kCgalTimeout : Verdict::kCgalFailed;
    if (!is_timeout) result.detail = "CGAL crashed";
  } else {
    result.verdict = values.contains("phase") ? Verdict::kUnexplained : Verdict::kMinksumFailed;
    result.detail = "the process ended early, status " + std::to_string(status);
  }
  return result;
}

}  // namespace

Child::Child(const Region& p, const Region& q, int cgal_limit) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no child process");
  if (process_ == 0) {
    close(ends[0]);
    run_child(p, q, cgal_limit, Teller(ends[1]));
    _exit(0);
  }
  close(ends[1]);
  pipe_ = ends[0];
}

Child::~Child() {
  if (pipe_ >= 0) close(pipe_);
}

Comparison Child::wait() {
  std::string said;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = read(pipe_, buffer.data(), buffer.size())) > 0;) {
    said.append(buffer.data(), static_cast<std::size_t>(n));
  }
  int status = 0;
  waitpid(process_, &status, 0);
  return understand(said, status);
}

Comparison compare_in_child(const Region& p, const Region& q, int cgal_limit) {
  return Child(p, q, cgal_limit).wait();
}

}  // namespace minksum::oracle

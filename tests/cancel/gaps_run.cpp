// Measures the longest processor time between two looks at a cancel token, for each operation on
// each hard input. Usage: gaps_run [--size VERTICES] [--seconds PER_CASE] [--most MILLISECONDS]
// [WORD...]
//
// Prints a line for each case that has the words in its name. The line has the longest time, and
// the time from the last look to the end, in which memory is freed. Exits with 1 if either is
// longer than MILLISECONDS.
#include <time.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "minksum/error.hpp"
#include "support/cancel_cases.hpp"

namespace minksum::test {
namespace {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The clock of one thread in one run.
struct ThreadClock {
  unsigned run = 0;
  double begin = 0;
  double last = 0;
};

/// Measures the gaps between looks of all threads. A thread's first look starts its clock.
class Gaps {
 public:
  Gaps(unsigned run, double seconds) : run_(run), seconds_(seconds) {}

  bool look() {
    ThreadClock& mine = clock();
    const double now = thread_seconds();
    if (mine.run != run_) mine = {run_, now, now};
    note(now - mine.last);
    mine.last = now;
    looks_.fetch_add(1);
    return now - mine.begin > seconds_;
  }
  /// Returns for how long this thread has not looked.
  [[nodiscard]] double since_last_look() const { return thread_seconds() - clock().last; }
  [[nodiscard]] double longest() const { return longest_.load(); }
  [[nodiscard]] unsigned long looks() const { return looks_.load(); }

 private:
  static ThreadClock& clock() {
    thread_local ThreadClock clock;
    return clock;
  }
  void note(double gap) {
    double before = longest_.load();
    while (gap > before && !longest_.compare_exchange_weak(before, gap)) {
    }
  }

  unsigned run_;
  double seconds_;
  std::atomic<double> longest_{0};
  std::atomic<unsigned long> looks_{0};
};

struct Arguments {
  int size = 4000;
  double seconds = 5;
  double most = 1e9;
  std::vector<std::string> words;
};

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--size" && has_value) {
      arguments.size = std::atoi(argv[++i]);
    } else if (word == "--seconds" && has_value) {
      arguments.seconds = std::atof(argv[++i]);
    } else if (word == "--most" && has_value) {
      arguments.most = std::atof(argv[++i]);
    } else {
      arguments.words.push_back(word);
    }
  }
  return arguments;
}

/// Returns whether no gap is too long.
bool measure(const CancelCase& hard, unsigned run, const Arguments& arguments) {
  Gaps gaps(run, arguments.seconds);
  const CancelToken token = CancelToken::polling([&gaps] { return gaps.look(); });
  gaps.look();
  const double begin = thread_seconds();
  std::string end = "done";
  try {
    hard.run({.cancel = token});
  } catch (const Error& error) {
    end = error.what();
  }
  const double seconds = thread_seconds() - begin;
  const double last = 1000 * gaps.since_last_look();
  const double longest = 1000 * gaps.longest();
  std::printf("%8.1f ms  %8.1f ms at the end  %7.2f s  %8lu looks  %-18s %-24s %s\n", longest, last,
              seconds, gaps.looks(), hard.operation.c_str(), hard.input.c_str(),
              end.substr(0, 40).c_str());
  std::fflush(stdout);
  return std::max(longest, last) <= arguments.most;
}

}  // namespace
}  // namespace minksum::test

int main(int argc, char** argv) {
  using namespace minksum::test;
  const Arguments arguments = parse(argc, argv);
  bool all = true;
  unsigned run = 0;
  for (const CancelCase& hard : cancel_cases(arguments.size)) {
    const std::string name = hard.operation + " " + hard.input;
    const bool wanted = std::ranges::all_of(arguments.words, [&](const std::string& word) {
      return name.find(word) != std::string::npos;
    });
    if (wanted) all = measure(hard, ++run, arguments) && all;
  }
  return all ? 0 : 1;
}

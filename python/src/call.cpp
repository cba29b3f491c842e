#include "call.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "errors.hpp"
#include "lock.hpp"

namespace nb = nanobind;

namespace minksum::python {
namespace {

using Clock = std::chrono::steady_clock;
// People do not notice a delay of a twentieth of a second. Ctrl-C is looked for more often than
// that, because a call also needs time to end. A look takes the interpreter's lock from other
// threads.
constexpr std::chrono::milliseconds kBetweenLooks{20};
/// The progress callback is called once in this time, or less often.
constexpr std::chrono::milliseconds kBetweenCalls{50};

std::size_t thread_count(std::optional<int> asked) {
  if (!asked) {
    const char* set = std::getenv("MINKSUM_NUM_THREADS");
    if (set != nullptr) asked = std::atoi(set);
  }
  if (asked.value_or(0) > 0) return static_cast<std::size_t>(*asked);
  // Asking the system takes longer than a small sum.
  static const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return cores;
}

/// Tells whether the exception that is being handled is about the call and not about an element:
/// Ctrl-C, a token, what the progress callback threw, or the time.
bool ends_call() {
  try {
    throw;
  } catch (const Error& error) {
    return error.code() == ErrorCode::kCancelled ||
           (error.limit() && error.limit()->name == "timeout");
  } catch (const std::bad_alloc&) {
    return false;
  } catch (...) {
    return true;
  }
}

bool on_main_thread() {
  const nb::object threading = nb::module_::import_("threading");
  return threading.attr("get_ident")().equal(threading.attr("main_thread")().attr("ident"));
}

/// Returns memory for small operations of this thread, which is kept from call to call.
Workspace& small_memory() {
  thread_local Workspace memory;
  return memory;
}

/// Lends memory to options, and takes it back at its end.
class Loan {
 public:
  Loan(Options& options, Workspace* memory) : options_(options) { options_.memory = memory; }
  ~Loan() { options_.memory = nullptr; }
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;

 private:
  Options& options_;
};

/// Gives memory back on a thread of its own: whoever presses Ctrl-C does not wait until gigabytes
/// are given back.
void give_back(std::unique_ptr<Workspace> memory) {
  try {
    std::thread([memory = std::move(memory)] {}).detach();
  } catch (const std::system_error&) {
    // The system gives no thread. The memory went with what would have run on it.
  }
}

constexpr const char* kSettingsSignature =
    "fill: str = 'automatic', regularize: bool = False, threads: int | None = None, "
    "max_segments: int | None = None, max_crossings: int | None = None, "
    "timeout: float | None = None, "
    "progress: typing.Callable[[str], bool | None] | None = None, "
    "cancel: CancelToken | None = None";

}  // namespace

const char* signature(const std::string& name, const std::string& operands, const std::string& own,
                      const std::string& result) {
  static std::deque<std::string> kept;
  return kept
      .emplace_back("def " + name + "(" + operands + ", *, " + own + kSettingsSignature + ") -> " +
                    result)
      .c_str();
}

bool forgives(const std::string& on_error) {
  return choice<bool>(on_error, "on_error", {{"raise", false}, {"none", true}});
}

bool is_bad_element() {
  try {
    throw;
  } catch (const ElementError&) {
    return true;
  } catch (const Error& error) {
    return error.code() == ErrorCode::kBadInput ||
           (error.code() == ErrorCode::kLimitExceeded &&
            !(error.limit() && error.limit()->name == "timeout"));
  } catch (...) {
    return false;
  }
}

FillRule rule_of(const std::string& word) {
  return choice<FillRule>(word, "fill",
                          {{"automatic", FillRule::kAutomatic},
                           {"evenodd", FillRule::kEvenOdd},
                           {"nonzero", FillRule::kNonZero},
                           {"positive", FillRule::kPositive},
                           {"negative", FillRule::kNegative},
                           {"strict", FillRule::kStrict}});
}

RoundingSide side_of(const std::string& word) {
  return choice<RoundingSide>(word, "the side",
                              {{"nearest", RoundingSide::kNearest},
                               {"outside", RoundingSide::kOutside},
                               {"inside", RoundingSide::kInside}});
}

struct Call::Watch {
  std::thread::id caller = std::this_thread::get_id();
  bool signals = on_main_thread();  // no other thread of Python handles them
  std::optional<CancelToken> token;
  std::optional<double> seconds;
  Clock::time_point deadline;
  Clock::time_point next_look = Clock::now() + kBetweenLooks;
  Clock::time_point next_progress;
  Stage stage = Stage::kSearch;
  nb::object progress;
  std::atomic<bool> stopped{false};

  bool stop() {
    if (stopped.load(std::memory_order_relaxed)) return true;
    if (token && token->cancelled()) return true;
    const bool calling = std::this_thread::get_id() == caller;
    if (!seconds && !(calling && signals)) return false;
    const Clock::time_point now = Clock::now();
    if (seconds && now > deadline) {
      throw Error(
          ErrorCode::kLimitExceeded,
          "the time that was allowed (timeout=" + std::to_string(*seconds) + " seconds) has passed",
          {}, {}, ExceededLimit{"timeout", 0});
    }
    if (calling && signals && now >= next_look) {
      next_look = now + kBetweenLooks;
      const Locked lock;
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
    }
    return false;
  }

  bool tell(const Progress& how_far) {
    if (std::this_thread::get_id() != caller) return true;
    const Clock::time_point now = Clock::now();
    if (how_far.stage == stage && now < next_progress) return true;
    stage = how_far.stage;
    next_progress = now + kBetweenCalls;
    const Locked lock;
    const nb::object answer = progress(to_string(how_far.stage));
    if (answer.is_none()) return true;
    const int yes = PyObject_IsTrue(answer.ptr());
    if (yes < 0) throw nb::python_error();
    return yes != 0;
  }

  // The last owner may hold no lock.
  ~Watch() {
    const Locked lock;
    progress.reset();
  }
};

Call::Call(MINKSUM_SETTINGS) : threads_(threads) {
  options_.fill = rule_of(fill);
  options_.regularize = regularize;
  if (max_segments) options_.limits.max_segments = *max_segments;
  if (max_crossings) options_.limits.max_crossings = *max_crossings;
  if (threads && *threads < 0) throw nb::value_error("threads must not be negative");
  if (!cancel && !timeout && progress.is_none()) return;
  start_watch();
  watch_->token = std::move(cancel);
  watch_->seconds = timeout;
  if (timeout) {
    if (!(*timeout > 0)) throw nb::value_error("timeout must be a positive number of seconds");
    const double most = 1e9;  // some thirty years, which a duration of the clock can hold
    watch_->deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(std::min(*timeout, most)));
  }
  if (!progress.is_none()) {
    watch_->progress = std::move(progress);
    options_.progress = [watch = watch_](const Progress& how_far) { return watch->tell(how_far); };
  }
}

void Call::start_watch() {
  if (watch_) return;
  watch_ = std::make_shared<Watch>();
  options_.cancel = CancelToken::polling([watch = watch_] { return watch->stop(); });
}

void Call::run(bool small, const std::function<void()>& operation) {
  if (small) {
    options_.threads = 1;
    // A progress callback may call the library again, which then needs memory of its own.
    const Loan loan(options_, watch_ ? nullptr : &small_memory());
    return operation();
  }
  start_watch();
  options_.threads = static_cast<int>(thread_count(threads_));
  auto memory = std::make_unique<Workspace>();
  const Unlocked unlocked;
  const Loan loan(options_, memory.get());
  try {
    operation();
  } catch (...) {
    if (ends_call()) give_back(std::move(memory));
    throw;
  }
}

void Call::for_each(const std::vector<std::size_t>& shape,
                    const std::function<void(std::size_t, const Options&)>& element) {
  start_watch();
  const std::size_t threads = thread_count(threads_);
  std::size_t count = 1;
  for (const std::size_t side : shape) count *= side;
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> running{0};
  std::mutex guard;
  std::size_t failed = count;
  std::exception_ptr error;
  const auto work = [&] {
    Workspace memory;
    Options options = options_;
    options.threads = 1;
    options.memory = &memory;
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        element(i, options);
      } catch (...) {
        if (forgives_ && is_bad_element()) continue;
        const std::lock_guard lock(guard);
        // Of several elements that fail, the first is named, whichever thread is faster. What ends
        // the whole call counts only once, because all other threads then end in the same way.
        const bool whole = ends_call();
        if (whole ? !watch_->stopped : i < failed && !watch_->stopped) {
          failed = i;
          error = std::current_exception();
        }
        if (whole) watch_->stopped = true;
        next = count;
        return;
      }
    }
  };
  {
    const Unlocked unlocked;
    std::vector<std::thread> helpers;
    helpers.reserve(std::min(threads, count));
    for (std::size_t t = 1; t < std::min(threads, count); ++t) {
      ++running;
      try {
        helpers.emplace_back([&] {
          work();
          --running;
        });
      } catch (const std::system_error&) {  // the system gives no more threads
        --running;
        break;
      }
    }
    work();
    // While helpers finish their last elements, this thread goes on looking for Ctrl-C.
    while (running > 0) {
      try {
        if (options_.cancel->cancelled()) watch_->stopped = true;
      } catch (...) {
        watch_->stopped = true;
        const std::lock_guard lock(guard);
        failed = 0;
        error = std::current_exception();
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    for (std::thread& helper : helpers) helper.join();
  }
  if (!error) return;
  try {
    std::rethrow_exception(error);
  } catch (const Error&) {
    throw ElementError{error, place_in(shape, failed)};
  }
}

}  // namespace minksum::python

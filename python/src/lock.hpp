// Holds the interpreter's lock and lets go of it.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace minksum::python {

/// The end of the interpreter. A thread that asks for its lock then loses its stack, and a
/// destructor of C++ on this stack ends the process by a signal. So `come` lets such threads sleep
/// until the process has ended.
class InterpreterEnd {
 public:
  /// A thread is about to take the lock, or to call Python.
  static void enter() {
    ++inside_;
    if (!is_over()) return;
    --inside_;
    while (is_over()) std::this_thread::sleep_for(std::chrono::hours(1));
  }
  static void leave() { --inside_; }

  /// Is called by the thread that ends the interpreter, with the lock, before anything ends. Waits
  /// until the others that take the lock have it, but not for ever: a progress callback may wait
  /// for something that this thread would do.
  static void come() {
    ending_ = std::this_thread::get_id();
    const nanobind::gil_scoped_release unlocked;
    for (int i = 0; i < 1000 && inside_ > 0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

 private:
  static bool is_over() {
    const std::thread::id ending = ending_;
    return ending != std::thread::id() && ending != std::this_thread::get_id();
  }

  inline static std::atomic<std::thread::id> ending_{};
  inline static std::atomic<int> inside_{0};
};

/// Lets go of the lock.
class Unlocked {
 public:
  Unlocked() : state_(PyEval_SaveThread()) { let_go = true; }
  ~Unlocked() {
    InterpreterEnd::enter();
    PyEval_RestoreThread(state_);
    InterpreterEnd::leave();
    let_go = false;
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

  /// Whether this thread had the lock and let go of it.
  inline static thread_local bool let_go = false;

 private:
  PyThreadState* state_;
};

/// Holds the lock to call Python, whether the thread has it or not.
class Locked {
 public:
  Locked() {
    if (takes_) InterpreterEnd::enter();
    Unlocked::let_go = false;
    state_ = PyGILState_Ensure();
  }
  ~Locked() {
    PyGILState_Release(state_);
    Unlocked::let_go = takes_;
    if (takes_) InterpreterEnd::leave();
  }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  bool takes_ = Unlocked::let_go;
  PyGILState_STATE state_;
};

}  // namespace minksum::python

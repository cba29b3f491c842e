// Defines what all threads of the library have in common.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

#if __has_include(<pthread.h>) && __has_include(<signal.h>)
#include <pthread.h>
#include <signal.h>
#define MINKSUM_POSIX_THREADS 1
#endif

namespace minksum {

/// Whether threads can start: WebAssembly by itself has none. What only several threads need is then
/// left out.
#if defined(__wasm__) && !defined(_REENTRANT)
inline constexpr bool kHasThreads = false;
#else
inline constexpr bool kHasThreads = true;
#endif

/// Blocks all signals in this thread. Signals from outside are for the threads of the library's
/// user.
inline void block_signals_in_this_thread() {
#ifdef MINKSUM_POSIX_THREADS
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
#endif
}

/// Returns how many threads `threads` means: 0 means one for each core.
[[nodiscard]] inline std::size_t thread_count(int threads) {
  return threads > 0 ? static_cast<std::size_t>(threads)
                     : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace minksum

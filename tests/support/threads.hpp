// Leaves out tests that start threads, or wait for one, where no thread starts.
#pragma once

#include <gtest/gtest.h>

/// Begins a test that needs a second thread.
#ifdef __EMSCRIPTEN__
#define MINKSUM_NEEDS_THREADS() GTEST_SKIP() << "WebAssembly is built without threads"
#else
#define MINKSUM_NEEDS_THREADS() static_cast<void>(0)
#endif

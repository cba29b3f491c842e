// Broken invariants and requests to stop, for all steps of the signed method.
#pragma once

#include "minksum/minkowski_sum.hpp"

namespace minksum::signed_sum {

/// An invariant of this method does not hold: a fault of the library, never of its input.
[[noreturn]] inline void broken(const char* message) {
  throw Error(ErrorCode::kInternal, message, {}, "signed convolution");
}

/// Throws Error(kCancelled) if the caller wants no result any more. Cheap enough for inner loops
/// when asked every few thousand steps.
inline void stop_if_asked(const Options& options, Stage stage) {
  const bool cancelled = options.cancel && options.cancel->cancelled();
  if (cancelled || (options.progress && !options.progress(stage))) {
    throw Error(ErrorCode::kCancelled, "the computation was cancelled");
  }
}

/// Calls stop_if_asked at every 4096th step of a loop.
class StopClock {
 public:
  StopClock(const Options& options, Stage stage) : options_(options), stage_(stage) {}
  void tick() {
    if ((++steps_ & 0xfffU) == 0) stop_if_asked(options_, stage_);
  }

 private:
  const Options& options_;
  Stage stage_;
  unsigned steps_ = 0;
};

}  // namespace minksum::signed_sum

// Broken invariants, for all steps of the signed method.
#pragma once

#include "machine/cancellation.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::signed_sum {

/// An invariant of this method does not hold: a fault of the library, never of its input.
[[noreturn]] inline void broken(const char* message) {
  throw Error(ErrorCode::kInternal, message, {}, "signed convolution");
}

}  // namespace minksum::signed_sum

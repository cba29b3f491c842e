// Reports broken invariants, for all steps of the signed method.
#pragma once

#include "machine/cancellation.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::signed_sum {

/// Throws because an invariant of this method does not hold. A broken invariant is a fault of the
/// library, and never of its input.
[[noreturn]] inline void broken(const char* message) {
  throw Error(ErrorCode::kInternal, message, {}, "signed convolution");
}

}  // namespace minksum::signed_sum

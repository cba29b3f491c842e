// Throws the error for an operand that is not valid.
#pragma once

#include "minksum/validity.hpp"

namespace minksum {

/// Throws Error(kBadInput) for a fault of this operand (Culprit::operand).
[[noreturn]] void reject(const Fault& fault, int operand);
/// Throws this error for the first fault of a region that is not valid (see `validate`).
void require_valid(const Region& region, int operand, const Options& options = {});

}  // namespace minksum

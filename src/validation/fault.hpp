// Throws the errors for operands that an operation cannot use.
#pragma once

#include <string>

#include "minksum/validity.hpp"

namespace minksum {

/// Throws Error(kBadInput) about an operand (Culprit::operand), and about a place in it.
[[noreturn]] void refuse_operand(const std::string& what, int operand, Culprit place = {});
/// Throws this error for a fault of an operand.
[[noreturn]] void reject(const Fault& fault, int operand);
/// Throws this error for the first fault of a region that is not valid (see `validate`).
void require_valid(const Region& region, int operand, const Options& options = {});

}  // namespace minksum

// Writes numbers for people to read.
#pragma once

#include <string>

#include "minksum/rational.hpp"

namespace minksum::cli {

/// Returns the exact number: a short decimal, or a fraction with an approximation. Numbers that are
/// too long to read are only approximated.
[[nodiscard]] std::string readable(const Rational& value);
/// Returns the fewest digits that are read back as the same double.
[[nodiscard]] std::string shortest(double value);

}  // namespace minksum::cli

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

/// Returns the number as a decimal: exactly if it is short, and else the nearest one, marked.
[[nodiscard]] std::string in_decimals(const Rational& value);

}  // namespace minksum::cli

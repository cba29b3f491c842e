// Numbers for people to read.
#pragma once

#include <string>

#include "minksum/rational.hpp"

namespace minksum::cli {

/// The number exactly: as a decimal if it is one of few digits, else as a fraction and about; only
/// about, if it is too long to read.
[[nodiscard]] std::string readable(const Rational& value);
/// The fewest digits that are read back as the same double.
[[nodiscard]] std::string shortest(double value);

}  // namespace minksum::cli

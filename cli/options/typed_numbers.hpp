// Reads numbers as people type them after options.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "minksum/rational.hpp"
#include "minksum/region.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

/// Returns the exact number of a text such as 1.5, .5, 5., 1e-3 or 2/3. Throws a Failure for wrong
/// usage, which names the option.
[[nodiscard]] Rational parse_number(const std::string& option, const std::string& text);

/// Returns `count` numbers that have `between` between them. Throws a Failure, whose message shows
/// `example`.
[[nodiscard]] std::vector<Rational> parse_numbers(const std::string& option,
                                                  const std::string& text, std::size_t count,
                                                  char between, const char* example);

/// Returns the point of a text such as X,Y. Throws a Failure.
[[nodiscard]] Point parse_point(const std::string& option, const std::string& text);

/// Returns a check that accepts numbers from `low` to `high`.
[[nodiscard]] ValueCheck between(double low, double high);

}  // namespace minksum::cli

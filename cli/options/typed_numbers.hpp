// Numbers as people type them after options.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "minksum/rational.hpp"
#include "minksum/region.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

/// The number, exactly: 1.5, .5, 5., 1e-3, 2/3. Throws a Failure for wrong usage, which names the
/// option.
[[nodiscard]] Rational parse_number(const std::string& option, const std::string& text);

/// So many numbers with `between` between them; `example` is what the message says. Throws a
/// Failure.
[[nodiscard]] std::vector<Rational> parse_numbers(const std::string& option,
                                                  const std::string& text, std::size_t count,
                                                  char between, const char* example);

/// X,Y. Throws a Failure.
[[nodiscard]] Point parse_point(const std::string& option, const std::string& text);

/// Takes what is from `low` to `high`.
[[nodiscard]] ValueCheck between(double low, double high);

}  // namespace minksum::cli

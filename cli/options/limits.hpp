// Declares the limits that the user sets: their options, and how the process keeps them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "minksum/io.hpp"
#include "minksum/minkowski_sum.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

struct ProcessLimits {
  io::ReadOptions read;
  Limits sum;
  /// Bytes of addresses; none = no limit. Without the option it is `default_memory`.
  std::optional<std::uint64_t> memory;
  double seconds = 0;  ///< 0 = no limit
};

/// Returns the size of the machine's memory; none where it is unknown or no useful limit.
[[nodiscard]] std::optional<std::uint64_t> default_memory();

/// Adds an option that takes a count (see parse_count). The parser rejects anything else.
Option add_count(const Command& command, const char* name, std::uint64_t& count, const char* what);

/// Adds --max-vertices, --max-bytes, --max-memory and --timeout; with `sum`, --max-segments and
/// --max-crossings as well. The parser rejects bad values.
void add_limit_options(const Command& command, ProcessLimits& limits, bool sum);

/// Adds --max-crossings alone.
void add_max_crossings(const Command& command, std::uint64_t& most, const char* what);

/// Adds --timeout alone.
void add_seconds(const Command& command, double& seconds, const char* what);

/// Makes the process keep the limits on memory and time from now on. If the system has set a lower
/// limit on memory, `limits.memory` becomes none.
void apply(ProcessLimits& limits);

/// Returns "4G" as 4 · 1024³; the suffixes are K, M, G and T. Returns nothing if it is not a size.
[[nodiscard]] std::optional<std::uint64_t> parse_size(const std::string& text);
/// Returns "2M" as 2,000,000; the suffixes are K, M and G. Returns nothing if it is not a count.
[[nodiscard]] std::optional<std::uint64_t> parse_count(const std::string& text);

}  // namespace minksum::cli

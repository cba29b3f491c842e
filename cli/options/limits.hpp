// Limits that the user sets: their options, and how the process keeps to them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "minksum/io.hpp"
#include "minksum/minkowski_sum.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

struct ProcessLimits {
  io::ReadLimits read;
  Limits sum;
  /// Bytes of addresses; none = no limit. Without the option: `default_memory`.
  std::optional<std::uint64_t> memory;
  double seconds = 0;  ///< 0 = no limit
};

/// As much as the machine has; none where that is not known or makes no sense.
[[nodiscard]] std::optional<std::uint64_t> default_memory();

/// Adds --max-vertices, --max-bytes, --max-memory and --timeout; with `sum`, --max-segments and
/// --max-crossings as well. What is typed wrongly is rejected by the parser.
void add_limit_options(const Command& command, ProcessLimits& limits, bool sum);

/// Adds --timeout alone.
void add_seconds(const Command& command, double& seconds, const char* what);

/// Makes the process keep to the limits on memory and time from now on. Afterwards there is none on
/// memory if the system has set a lower one.
void apply(ProcessLimits& limits);

/// "4G" as 4 · 1024³; the suffixes are K, M, G and T. Nothing if it is no size.
[[nodiscard]] std::optional<std::uint64_t> parse_size(const std::string& text);
/// "2M" as 2,000,000; the suffixes are K, M and G. Nothing if it is no count.
[[nodiscard]] std::optional<std::uint64_t> parse_count(const std::string& text);

}  // namespace minksum::cli

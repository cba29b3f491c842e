#include "options/limits.hpp"

#include <charconv>
#include <limits>
#include <string_view>

#include "options/drawing_options.hpp"
#include "process/process.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kGroup = "Limits (exit code 3 beyond; K, M, G may follow a number)";

std::optional<std::uint64_t> parse_with_suffix(std::string_view text, std::string_view suffixes,
                                               std::uint64_t base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return {};
  const std::string_view suffix = text.substr(static_cast<std::size_t>(end - text.data()));
  if (suffix.empty()) return value;
  const std::size_t power = suffixes.find(suffix);
  if (suffix.size() != 1 || power == std::string_view::npos) return {};
  for (std::size_t i = 0; i <= power; ++i) {
    if (value > std::numeric_limits<std::uint64_t>::max() / base) return {};
    value *= base;
  }
  return value;
}

std::uint64_t take_size(const char* name, const std::string& text) {
  const std::optional<std::uint64_t> size = parse_size(text);
  if (!size) {
    reject_value(name, "takes a size in bytes as 100000, 512M or 4G, not '" + text + "'");
  }
  return *size;
}

double take_seconds(const std::string& text) {
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  constexpr double kMost = 1e8;  // three years, which the timer of any system accepts
  if (error != std::errc() || end != text.data() + text.size() || !(seconds > 0) ||
      seconds > kMost) {
    reject_value("--timeout", "takes seconds as 10 or 0.5, not '" + text + "'");
  }
  return seconds;
}

}  // namespace

std::optional<std::uint64_t> parse_size(const std::string& text) {
  return parse_with_suffix(text, "KMGT", 1024);
}

std::optional<std::uint64_t> parse_count(const std::string& text) {
  return parse_with_suffix(text, "KMG", 1000);
}

std::optional<std::uint64_t> default_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return {};  // a sanitizer reserves more addresses than memory exists
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
  return {};
#endif
#endif
  const std::uint64_t bytes = available_memory();
  return bytes > 0 ? std::optional(bytes) : std::nullopt;
}

Option add_count(const Command& command, const char* name, std::uint64_t& count, const char* what) {
  return command
      .add_option(
          name,
          [name, &count](const std::string& text) {
            const std::optional<std::uint64_t> value = parse_count(text);
            if (!value) {
              reject_value(name, "takes a count as 500000, 500K or 2M, not '" + text + "'");
            }
            count = *value;
          },
          what)
      .type_name("N");
}

void add_limit_options(const Command& command, ProcessLimits& limits, bool sum) {
  limits.memory = default_memory();
  add_count(command, "--max-vertices", limits.read.max_vertices,
            "Vertices of an operand (default 2^30)")
      .group(kGroup);
  if (sum) {
    add_count(command, "--max-segments", limits.sum.max_segments,
              "Segments of the convolution (default 2^28)")
        .group(kGroup);
    add_max_crossings(command, limits.sum.max_crossings, "Crossings among them (default 2^28)");
  }
  command
      .add_option(
          "--max-bytes",
          [&limits](const std::string& text) {
            limits.read.max_bytes = take_size("--max-bytes", text);
          },
          "Length of an operand's text (default 1G)")
      .type_name("SIZE")
      .group(kGroup);
  command
      .add_option(
          "--max-memory",
          [&limits](const std::string& text) {
            limits.memory.reset();
            if (text != "none") limits.memory = take_size("--max-memory", text);
          },
          "Memory of the process, or none (default: what the machine has)")
      .type_name("SIZE")
      .group(kGroup);
  add_seconds(command, limits.seconds, "Time for everything (default: none)");
  command.add_flag("--drop-z", limits.read.drop_z,
                   "Drop heights and measures (Z, M) of operands; they are errors otherwise");
  command
      .add_option("--column", limits.read.column,
                  "The column of a table (CSV, TSV) that holds the geometries; found without it")
      .type_name("NAME");
  // An offset has a tolerance and a side of its own, which hold for its operand, too.
  add_drawing_options(command, limits.read.drawing, command.name() == "offset");
}

void add_max_crossings(const Command& command, std::uint64_t& most, const char* what) {
  add_count(command, "--max-crossings", most, what).group(kGroup);
}

void add_seconds(const Command& command, double& seconds, const char* what) {
  command
      .add_option(
          "--timeout", [&seconds](const std::string& text) { seconds = take_seconds(text); }, what)
      .type_name("SECONDS")
      .group(kGroup);
}

void apply(ProcessLimits& limits) {
  if (limits.seconds > 0) end_after(limits.seconds);
  if (limits.memory && !limit_memory(*limits.memory)) limits.memory.reset();
}

}  // namespace minksum::cli

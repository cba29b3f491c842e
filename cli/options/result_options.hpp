// The options that say where and how a result is written.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

/// These options as they are typed; turned into ResultArguments when all of them are known.
struct ResultText {
  std::string format;
  std::string coordinates = "double";
  std::string round;
};

/// Adds -o, --format, --coords and --round; `result` is what messages call it: "sum".
void add_result_options(const Command& command, ResultArguments& arguments, ResultText& typed,
                        const std::string& result);

/// Fills `arguments`. Throws a Failure for wrong usage.
void convert_result(ResultArguments& arguments, const ResultText& typed);

/// What --round and --side take.
[[nodiscard]] const std::map<std::string, RoundingSide>& rounding_sides();

/// The format that was asked for, or the one that the output's name ends in, or WKT.
[[nodiscard]] io::Format choose_format(const std::string& typed, const std::string& output);

/// The keys of a map, for Option::one_of.
[[nodiscard]] std::vector<std::string> names_of(const auto& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

}  // namespace minksum::cli

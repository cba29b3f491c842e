// Declares the options that say where and how a result is written.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

/// Options as they are typed; `convert_result` turns them into ResultArguments.
struct ResultText {
  std::string format;
  std::string coordinates = "double";
  std::string round;
};

/// Adds -o, --format, --coords and --round. Texts call the result `result`, such as "sum".
void add_result_options(const Command& command, ResultArguments& arguments, ResultText& typed,
                        const std::string& result);

/// Fills `arguments`. Throws a Failure for wrong usage.
void convert_result(ResultArguments& arguments, const ResultText& typed);

/// Returns the values that --round and --side take, by name.
[[nodiscard]] const std::map<std::string, RoundingSide>& rounding_sides();

/// Returns the format that was typed, else that of the output's ending, else WKT.
[[nodiscard]] io::Format choose_format(const std::string& typed, const std::string& output);

/// Returns the keys of a map, for Option::one_of.
[[nodiscard]] std::vector<std::string> names_of(const auto& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

}  // namespace minksum::cli

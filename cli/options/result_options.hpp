// Declares the options that say where and how a result is written.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

/// Adds --each and --restart. --each cannot be given with the options `without`.
void add_each_options(const Command& command, EachArguments& arguments,
                      const std::vector<const char*>& without);

/// Adds a positional that is the name of a file.
Option add_operand(const Command& command, const char* name, std::string& file, const char* what);

/// Adds -o, --format, --coords and --round. Texts call the result `result`, such as "sum".
void add_result_options(const Command& command, ResultArguments& arguments,
                        const std::string& result);

/// Sets what follows from what was typed. Throws a Failure for wrong usage.
void convert_result(ResultArguments& arguments);
/// Does the same for a result whose format does not follow from what was typed.
void convert_numbers(ResultArguments& arguments);

/// Returns the values that --round and --side take, by name.
[[nodiscard]] const std::map<std::string, RoundingSide>& rounding_sides();

/// Returns the format that was typed, else that of the output's ending, else WKT. Throws a Failure
/// for an ending that no format has.
[[nodiscard]] io::Format choose_format(const std::string& typed, const std::string& output);

/// Returns the keys of a map, for Option::one_of.
[[nodiscard]] std::vector<std::string> names_of(const auto& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

/// Adds an option that takes one of the names, and sets its value.
template <class Value>
Option add_choice(const Command& command, const char* name,
                  const std::map<std::string, Value>& values, Value& value, const char* what) {
  return command
      .add_option(
          name, [&](const std::string& typed) { value = values.at(typed); }, what)
      .one_of(names_of(values));
}

}  // namespace minksum::cli

// Finds the name that a misspelt word most likely stands for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

/// Returns the text with the letters A to Z in lower case.
[[nodiscard]] std::string in_lower_case(std::string_view text);

/// Returns the name that is most like the word, whatever the case; none if no name is like it.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view word,
                                                      const std::vector<std::string>& names);

/// Returns " (did you mean 'NAME'?)" for the nearest name, with `before` in front of the name;
/// empty if no name is like the word.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& names,
                                       const char* before = "");

}  // namespace minksum::cli

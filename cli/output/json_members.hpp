// Finds the members of a JSON object as they stand in its text, so that numbers keep all digits.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

struct JsonMember {
  std::string key;
  std::string_view value;  ///< within the text
};

/// Returns the members of the object `text` in their order; nothing if `text` is not a JSON object.
[[nodiscard]] std::optional<std::vector<JsonMember>> json_members(std::string_view text);
/// Returns the elements of the array `text`, which must be valid JSON; nothing if it is not an
/// array.
[[nodiscard]] std::optional<std::vector<std::string_view>> json_elements(std::string_view text);
/// Returns the value of the string `text`, which must be valid JSON; nothing if it is not a string.
[[nodiscard]] std::optional<std::string> json_string(std::string_view text);
/// Returns `text` as a JSON string; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string to_json(std::string_view text);

}  // namespace minksum::cli

// The members of a JSON object as they stand in its text: numbers keep all their digits.
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

/// The members of the object that `text` is, in their order; nothing if it is no JSON object.
[[nodiscard]] std::optional<std::vector<JsonMember>> json_members(std::string_view text);
/// The elements of the array that `text`, which is valid JSON, is; nothing if it is no array.
[[nodiscard]] std::optional<std::vector<std::string_view>> json_elements(std::string_view text);
/// The string that `text`, which is valid JSON, is; nothing if it is no string.
[[nodiscard]] std::optional<std::string> json_string(std::string_view text);
/// `text` as a JSON string; what is not UTF-8 is replaced.
[[nodiscard]] std::string to_json(std::string_view text);

}  // namespace minksum::cli

// Writes text as a string of JSON.
#pragma once

#include <string>
#include <string_view>

namespace minksum::io {

[[nodiscard]] bool is_utf8(std::string_view text);

/// Returns the text in quotes, with escapes. The text must be UTF-8.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace minksum::io

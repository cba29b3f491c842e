// Writes text as a string of JSON.
#pragma once

#include <string>
#include <string_view>

namespace minksum::io {

[[nodiscard]] bool is_utf8(std::string_view text);
/// Says what to do with a text that is not. Latin-1 is what it is most often.
inline constexpr const char* kToUtf8 = "; convert it first, as by iconv -f latin1 -t utf-8";

/// Returns the text in quotes, with escapes. The text must be UTF-8.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace minksum::io

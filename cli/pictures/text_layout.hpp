// Text that comes from outside: lines of it for pictures, whose fonts are not known, and what
// neither pictures nor terminals can take.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

/// How many characters UTF-8 text has.
[[nodiscard]] std::size_t character_count(std::string_view text);

/// The text in lines of up to so many characters (one at least): between words, where that is
/// possible, else within them.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t characters);

/// Whether the text is UTF-8 without control characters (U+0000 to U+001F, U+007F to U+009F) and
/// without U+FFFE and U+FFFF, which XML has not.
[[nodiscard]] bool is_printable(std::string_view text);
/// The text with each character, and each byte that is none, that is not printable as `instead` has
/// it.
[[nodiscard]] std::string printable(std::string_view text,
                                    const std::function<std::string(std::string_view)>& instead);

}  // namespace minksum::cli

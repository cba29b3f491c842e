// Lines of text for pictures, whose fonts are not known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

/// How many characters UTF-8 text has.
[[nodiscard]] std::size_t character_count(std::string_view text);

/// The text in lines of up to so many characters (one at least): between words, where that is
/// possible, else within them.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t characters);

}  // namespace minksum::cli

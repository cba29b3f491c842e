// Treats text from outside: breaks it into lines for pictures, whose fonts are not known, and finds
// characters that pictures and terminals cannot show.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

/// About the width of a character in the widest usual font. Fonts are not known here.
inline constexpr double kCharacterWidth = 7.4;

/// Returns how many characters a UTF-8 text has.
[[nodiscard]] std::size_t character_count(std::string_view text);

/// Breaks the text into lines of at most `characters` characters, which must be at least one. Lines
/// break between words where possible, else within words.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t characters);

/// Returns whether the text is UTF-8 without control characters (U+0000 to U+001F, U+007F to
/// U+009F) and without U+FFFE and U+FFFF, which XML forbids.
[[nodiscard]] bool is_printable(std::string_view text);
/// Returns the text with `instead(part)` for each character that is not printable, and for each
/// byte that belongs to no character.
[[nodiscard]] std::string printable(std::string_view text,
                                    const std::function<std::string(std::string_view)>& instead);

}  // namespace minksum::cli

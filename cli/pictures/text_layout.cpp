#include "pictures/text_layout.hpp"

#include <algorithm>

#include "minksum/detail/utf8.hpp"

namespace minksum::cli {
namespace {

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

// Returns how many bytes the first `characters` characters take.
std::size_t bytes_of(std::string_view text, std::size_t characters) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (begins_character(text[at]) && characters-- == 0) break;
  }
  return at;
}

// Returns the length in bytes of the first character, or 0 if it is not printable.
std::size_t printable_length(std::string_view text) {
  const std::size_t length = detail::utf8_length(text);
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const bool control = (length == 1 && (byte(0) < 0x20 || byte(0) == 0x7f)) ||
                       (length == 2 && byte(0) == 0xc2 && byte(1) < 0xa0);
  const bool no_character = text.starts_with("\xef\xbf\xbe") || text.starts_with("\xef\xbf\xbf");
  return control || no_character ? 0 : length;
}

}  // namespace

bool is_printable(std::string_view text) {
  while (const std::size_t length = printable_length(text)) text.remove_prefix(length);
  return text.empty();
}

std::string printable(std::string_view text,
                      const std::function<std::string(std::string_view)>& instead) {
  std::string result;
  while (!text.empty()) {
    const std::size_t good = printable_length(text);
    const std::size_t length = std::max({good, detail::utf8_length(text), std::size_t{1}});
    const std::string_view part = text.substr(0, length);
    good > 0 ? result += part : result += instead(part);
    text.remove_prefix(length);
  }
  return result;
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t characters) {
  std::vector<std::string> lines;
  const std::size_t most = std::max<std::size_t>(characters, 1);
  while (character_count(text) > most) {
    const std::size_t end = bytes_of(text, most);
    // A space just behind the line also allows a break.
    const std::size_t space = text.rfind(' ', end);
    const bool between_words = space != std::string_view::npos && space > 0;
    lines.emplace_back(text.substr(0, between_words ? space : end));
    text.remove_prefix(between_words ? space + 1 : end);
  }
  lines.emplace_back(text);
  return lines;
}

}  // namespace minksum::cli

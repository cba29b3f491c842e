#include "text_layout.hpp"

#include <algorithm>

namespace minksum::cli {
namespace {

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

// The bytes of the first so many characters.
std::size_t bytes_of(std::string_view text, std::size_t characters) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (begins_character(text[at]) && characters-- == 0) break;
  }
  return at;
}

}  // namespace

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t characters) {
  std::vector<std::string> lines;
  const std::size_t most = std::max<std::size_t>(characters, 1);
  while (character_count(text) > most) {
    const std::size_t end = bytes_of(text, most);
    // A space just behind the line is as good as one in it.
    const std::size_t space = text.rfind(' ', end);
    const bool between_words = space != std::string_view::npos && space > 0;
    lines.emplace_back(text.substr(0, between_words ? space : end));
    text.remove_prefix(between_words ? space + 1 : end);
  }
  lines.emplace_back(text);
  return lines;
}

}  // namespace minksum::cli

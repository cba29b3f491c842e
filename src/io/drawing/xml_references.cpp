#include "io/drawing/xml_references.hpp"

#include <algorithm>
#include <utility>

#include "io/text_cursor.hpp"

namespace minksum::io {
namespace {

std::string_view take_word(std::string_view& text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  std::size_t length = 0;
  while (length < text.size() && !is_space(text[length])) ++length;
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

}  // namespace

XmlReferences::XmlReferences(std::string_view prolog) {
  constexpr std::string_view kEntity = "<!ENTITY";
  for (std::size_t at; (at = prolog.find(kEntity)) != std::string_view::npos;) {
    prolog.remove_prefix(at + kEntity.size());
    const std::string_view name = take_word(prolog);
    prolog.remove_prefix(std::min(prolog.find_first_not_of(" \t\r\n"), prolog.size()));
    if (!prolog.starts_with('"') && !prolog.starts_with('\'')) continue;
    const std::size_t end = std::min(prolog.find(prolog.front(), 1), prolog.size());
    entities_.emplace(name, texts_.size());
    texts_.push_back(prolog.substr(1, end - 1));
    prolog.remove_prefix(end);
  }
}

std::string_view XmlReferences::expanded(std::string_view value) {
  const auto [place, is_new] = known_.emplace(value, 0);
  if (is_new) {
    place->second = expanded_.size();
    std::string text;
    append(value, 0, text);
    expanded_.push_back(std::make_unique<std::string>(std::move(text)));
  }
  return *expanded_[place->second];
}

void XmlReferences::append(std::string_view value, int depth, std::string& to) {
  for (;;) {
    const std::size_t at = std::min(value.find('&'), value.size());
    room_ -= std::min(at, room_);
    to += value.substr(0, at);
    if (at == value.size()) return;
    value.remove_prefix(at + 1);
    const std::size_t end = value.find(';');
    if (end != std::string_view::npos && append_one(value.substr(0, end), depth, to)) {
      value.remove_prefix(end + 1);
    } else {
      to += '&';
    }
  }
}

bool XmlReferences::append_one(std::string_view name, int depth, std::string& to) {
  constexpr int kDeepest = 8;
  if (name.starts_with('#')) {
    const bool hexadecimal = name.starts_with("#x");
    int code = 0;
    for (const char c : name.substr(hexadecimal ? 2 : 1)) {
      const int letter = (c | ' ') - 'a';
      const bool is_hexadecimal = hexadecimal && letter >= 0 && letter < 6;
      if ((!is_digit(c) && !is_hexadecimal) || code > 127) return false;
      code = code * (hexadecimal ? 16 : 10) + (is_digit(c) ? c - '0' : letter + 10);
    }
    if (code > 127) return false;
    to += static_cast<char>(code);
    return true;
  }
  const auto found = entities_.find(name);
  if (found == entities_.end() || depth == kDeepest || room_ == 0) return false;
  append(texts_[found->second], depth + 1, to);
  return true;
}

}  // namespace minksum::io

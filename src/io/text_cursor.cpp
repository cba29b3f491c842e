#include "io/text_cursor.hpp"

#include <algorithm>

namespace minksum::io {

void TextCursor::skip_space_and_comments() {
  for (;;) {
    skip_space();
    if (peek() != '#') return;
    position_ = std::min(text_.find('\n', position_), text_.size());
  }
}

std::string TextCursor::take_word() {
  std::string word;
  while (!at_end() && is_letter(text_[position_])) {
    const char c = text_[position_++];
    word += c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return word;
}

std::string TextCursor::found() const {
  constexpr std::size_t kLongest = 24;
  if (at_end()) return "the end of the text";
  const auto is_word = [](char c) {
    return is_letter(c) || is_digit(c) || c == '.' || c == '+' || c == '-' || c == '_' || c == '/';
  };
  const std::string_view here = rest();
  std::size_t length = 0;
  while (length < here.size() && length <= kLongest && is_word(here[length])) ++length;
  if (length > kLongest) return '\'' + std::string(here.substr(0, kLongest)) + "...'";
  if (length > 0) return '\'' + std::string(here.substr(0, length)) + '\'';
  const char c = here[0];
  if (c == '\n') return "the end of the line";
  if (c >= ' ' && c <= '~') return '\'' + std::string(1, c) + '\'';
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("byte 0x") + kHex[byte >> 4] + kHex[byte & 15];
}

void TextCursor::fail(ErrorCode code, const std::string& message, std::size_t position,
                      const std::optional<ExceededLimit>& limit) const {
  const std::string record =
      record_.empty() ? "" : std::string(record_) + ' ' + std::to_string(record_number_) + ": ";
  if (counts_ == Counts::kBytes) {
    throw ReadError(code, record + "byte " + std::to_string(position + 1) + ": " + message, 0, 0,
                    limit);
  }
  const std::string_view before = text_.substr(0, position);
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  const std::string_view in_line = before.substr(line_start);
  // Columns count characters, so the later bytes of a UTF-8 sequence do not count.
  const auto column = std::count_if(in_line.begin(), in_line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  throw ReadError(code, record + message, line, static_cast<std::size_t>(column) + 1, limit);
}

void TextCursor::fail_expected(const std::string& what) const {
  fail("expected " + what + ", found " + found());
}

void fail_too_deep(const TextCursor& cursor, int limit) {
  cursor.fail(ErrorCode::kLimitExceeded,
              "brackets are nested deeper than the limit of " + std::to_string(limit),
              cursor.position(),
              ExceededLimit{"io::ReadOptions::max_depth", static_cast<std::uint64_t>(limit)});
}

DepthGuard::DepthGuard(const TextCursor& cursor, int& depth, int limit) : depth_(depth) {
  if (depth_ >= limit) fail_too_deep(cursor, limit);
  ++depth_;
}

}  // namespace minksum::io

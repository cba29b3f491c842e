#include "io/json_cursor.hpp"

#include "io/json_string.hpp"
#include "io/number.hpp"
#include "minksum/detail/utf8.hpp"

namespace minksum::io {

namespace {

// Returns the length of the prefix that a string takes over unchanged. It ends at a quote, an
// escape, a control character, or a byte that is not UTF-8.
std::size_t plain_length(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && text[at] != '"' && text[at] != '\\' &&
         static_cast<unsigned char>(text[at]) >= 0x20) {
    const std::size_t length = detail::utf8_length(text.substr(at));
    if (length == 0) break;
    at += length;
  }
  return at;
}

void append_utf8(std::string& out, unsigned code) {
  const auto byte = [&out](unsigned value) { out += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | (code >> 6));
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | (code >> 18));
    byte(0x80 | ((code >> 12) & 0x3F));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

}  // namespace

void JsonCursor::expect(char c, const char* what) {
  if (!accept(c)) cursor_.fail_expected(what);
}

void JsonCursor::enter(char open, const char* what) {
  expect(open, what);
  if (depth_ >= max_depth_) fail_too_deep(cursor_, max_depth_);
  ++depth_;
}

std::string JsonCursor::take_name() {
  if (peek() != '"') cursor_.fail_expected("the name of a member in quotes");
  std::string name = take_string();
  expect(':', "':'");
  skip_space();
  return name;
}

std::string JsonCursor::take_string() {
  const std::size_t start = cursor_.position();
  cursor_.advance();  // the opening quote
  std::string result;
  for (;;) {
    const std::string_view rest = cursor_.rest();
    const std::size_t plain = plain_length(rest);
    result += rest.substr(0, plain);
    cursor_.advance(plain);
    if (cursor_.at_end()) cursor_.fail(ErrorCode::kBadInput, "a string has no end", start);
    if (cursor_.accept('"')) return result;
    if (static_cast<unsigned char>(cursor_.peek()) >= 0x80) {
      cursor_.fail("a string must be in UTF-8, found " + cursor_.found() + kToUtf8);
    }
    if (!cursor_.accept('\\')) {
      cursor_.fail("a control character in a string must be escaped, found " + cursor_.found());
    }
    append_escape(result);
  }
}

unsigned JsonCursor::take_hex4() {
  unsigned value = 0;
  for (int i = 0; i < 4; ++i) {
    constexpr std::string_view kDigits = "0123456789abcdef0123456789ABCDEF";
    const std::size_t digit =
        cursor_.at_end() ? std::string_view::npos : kDigits.find(cursor_.peek());
    if (digit == std::string_view::npos) cursor_.fail_expected("four hexadecimal digits");
    value = value * 16 + static_cast<unsigned>(digit % 16);
    cursor_.advance();
  }
  return value;
}

void JsonCursor::append_escape(std::string& out) {
  constexpr std::string_view kNames = "\"\\/bfnrt";
  constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
  if (cursor_.accept('u')) {
    unsigned code = take_hex4();
    if (code >= 0xD800 && code < 0xDC00 && cursor_.rest().starts_with("\\u")) {
      cursor_.advance(2);
      const unsigned low = take_hex4();
      if (low < 0xDC00 || low >= 0xE000) cursor_.fail("half of a surrogate pair in a string");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    } else if (code >= 0xD800 && code < 0xE000) {
      cursor_.fail("half of a surrogate pair in a string");
    }
    append_utf8(out, code);
    return;
  }
  const std::size_t index = cursor_.at_end() ? std::string_view::npos : kNames.find(cursor_.peek());
  if (index == std::string_view::npos) cursor_.fail_expected("an escape that JSON knows");
  out += kMeanings[index];
  cursor_.advance();
}

void JsonCursor::skip_literal(std::string_view literal) {
  if (!cursor_.rest().starts_with(literal)) cursor_.fail_expected("a JSON value");
  cursor_.advance(literal.size());
}

void JsonCursor::skip_value() {
  switch (peek()) {
    case '{':
      object("'{'", [this](const std::string&) { skip_value(); });
      return;
    case '[':
      array("'['", [this] { skip_value(); });
      return;
    case '"':
      take_string();
      return;
    case 't':
      skip_literal("true");
      return;
    case 'f':
      skip_literal("false");
      return;
    case 'n':
      skip_literal("null");
      return;
    default:
      break;
  }
  if (peek() != '-' && !is_digit(peek())) cursor_.fail_expected("a JSON value");
  static_cast<void>(scan_number(cursor_, NumberSyntax::kJson));
}

}  // namespace minksum::io

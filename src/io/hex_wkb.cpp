// Reads WKB whose bytes are written as hexadecimal digits.
#include <string>

#include "io/formats.hpp"
#include "io/text_cursor.hpp"
#include "machine/cancellation.hpp"

namespace minksum::io {

namespace {

int digit_of(char c) {
  if (is_digit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Returns the text from its first digit on. `\x` is what PostgreSQL writes before bytes.
std::string_view digits_of(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  if (text.starts_with("\\x") || text.starts_with("0x")) text.remove_prefix(2);
  return text;
}

}  // namespace

bool looks_like_hex_wkb(std::string_view text) {
  constexpr std::size_t kLeast = 9;  // bytes of a collection of nothing
  const std::string_view digits = digits_of(text).substr(0, 2 * kLeast);
  if (digits.size() < 2 * kLeast) return false;
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const int high = digit_of(digits[i]);
    const int low = digit_of(digits[i + 1]);
    if (high < 0 || low < 0) return false;
    bytes += static_cast<char>(16 * high + low);
  }
  return looks_like_wkb(bytes);
}

Geometry read_hex_wkb(std::string_view text, const ReadLimits& limits, Rules rules) {
  const Options options{.cancel = limits.cancel};
  Cancellation cancellation(options);
  TextCursor cursor(text);
  cursor.move_to(static_cast<std::size_t>(digits_of(text).data() - text.data()));
  std::string bytes;
  bytes.reserve(cursor.rest().size() / 2);
  while (digit_of(cursor.peek()) >= 0) {
    cancellation.check();
    const int high = digit_of(cursor.peek());
    cursor.advance();
    if (digit_of(cursor.peek()) < 0) cursor.fail_expected("a second hexadecimal digit of the byte");
    bytes += static_cast<char>(16 * high + digit_of(cursor.peek()));
    cursor.advance();
  }
  cursor.skip_space();
  if (!cursor.at_end()) cursor.fail_expected("a hexadecimal digit, or the end");
  return read_wkb(bytes, limits, rules);
}

}  // namespace minksum::io

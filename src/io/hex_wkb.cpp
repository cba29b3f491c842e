// Reads WKB whose bytes are written as hexadecimal digits.
#include <string>
#include <utility>

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

void read_hex_wkb(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder) {
  const Options cancel{.cancel = options.cancel};
  Cancellation cancellation(cancel);
  const std::size_t start = cursor.position();
  cursor.move_to(static_cast<std::size_t>(digits_of(cursor.rest()).data() - cursor.text().data()));
  std::string bytes;
  while (digit_of(cursor.peek()) >= 0) {
    cancellation.check();
    const int high = digit_of(cursor.peek());
    cursor.advance();
    if (digit_of(cursor.peek()) < 0) cursor.fail_expected("a second hexadecimal digit of the byte");
    bytes += static_cast<char>(16 * high + digit_of(cursor.peek()));
    cursor.advance();
  }
  if (is_letter(cursor.peek())) cursor.fail_expected("a hexadecimal digit, or the end of the line");
  try {
    read_wkb(bytes, options, builder);
  } catch (const ReadError& error) {  // it knows the byte, but not the line
    cursor.fail(error.code(), error.what(), start, error.limit());
  }
  builder.follow(cursor);
}

void write_hex_wkb(const Sink& out, const GeometryView& geometry, const Coordinates& style) {
  std::string digits;
  const auto add = [&digits](std::string_view bytes) {
    for (const char c : bytes) {
      const auto byte = static_cast<unsigned char>(c);
      digits += "0123456789ABCDEF"[byte >> 4];
      digits += "0123456789ABCDEF"[byte & 15];
    }
  };
  write_wkb(add, geometry, style);
  out(digits);
}

}  // namespace minksum::io

// Reads strict JSON (RFC 8259) token by token from a text in memory.
#pragma once

#include <string>
#include <string_view>

#include "io/text_cursor.hpp"

namespace minksum::io {

/// Walks over a JSON text on request. Numbers stay text until their reader takes them, so that no
/// number passes through a double.
class JsonCursor {
 public:
  JsonCursor(std::string_view text, int max_depth) : cursor_(text), max_depth_(max_depth) {}

  [[nodiscard]] TextCursor& text() { return cursor_; }
  /// Skips white space and returns the first character of the next value or mark.
  [[nodiscard]] char peek() {
    skip_space();
    return cursor_.peek();
  }
  void skip_space() {
    while (!cursor_.at_end()) {
      const char c = cursor_.peek();
      if (c != ' ' && c != '\n' && c != '\r' && c != '\t') return;
      cursor_.advance();
    }
  }
  [[nodiscard]] bool accept(char c) {
    skip_space();
    return cursor_.accept(c);
  }
  void expect(char c, const char* what);

  /// Reads a string; escapes are decoded.
  std::string take_string();
  /// Passes over a value of any kind, which must be valid JSON.
  void skip_value();

  /// Calls item() for each element of the array here; item must read that element.
  template <typename Item>
  void array(const char* what, Item item) {
    expect('[', what);
    const DepthGuard guard(cursor_, depth_, max_depth_);
    if (accept(']')) return;
    do {
      skip_space();
      item();
    } while (accept(','));
    expect(']', "',' or ']'");
  }
  /// Calls member(name) for each member of the object here. The cursor then stands at the member's
  /// value, and `member` must read that value.
  template <typename Member>
  void object(const char* what, Member member) {
    expect('{', what);
    const DepthGuard guard(cursor_, depth_, max_depth_);
    if (accept('}')) return;
    do {
      if (peek() != '"') cursor_.fail_expected("the name of a member in quotes");
      const std::string name = take_string();
      expect(':', "':'");
      skip_space();
      member(name);
    } while (accept(','));
    expect('}', "',' or '}'");
  }

 private:
  void skip_literal(std::string_view literal);
  void append_escape(std::string& out);
  unsigned take_hex4();

  TextCursor cursor_;
  int depth_ = 0;
  int max_depth_;
};

}  // namespace minksum::io

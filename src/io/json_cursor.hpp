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

  /// Begins the array or object here, whose bracket is `open`.
  void enter(char open, const char* what);
  /// Goes on to the next item of what was entered, or ends it behind its bracket `close`. Returns
  /// whether there is an item. `first` must be true at first.
  [[nodiscard]] bool next_item(bool& first, char close) {
    if (first ? !accept(close) : accept(',')) {
      first = false;
      skip_space();
      return true;
    }
    if (!first) expect(close, close == ']' ? "',' or ']'" : "',' or '}'");
    --depth_;
    return false;
  }
  /// Takes the name of a member. The cursor then stands at its value.
  std::string take_name();

  /// Calls item() for each element of the array here; item must read that element.
  template <typename Item>
  void array(const char* what, Item item) {
    enter('[', what);
    for (bool first = true; next_item(first, ']');) item();
  }
  /// Calls member(name) for each member of the object here. The cursor then stands at the member's
  /// value, and `member` must read that value.
  template <typename Member>
  void object(const char* what, Member member) {
    enter('{', what);
    for (bool first = true; next_item(first, '}');) member(take_name());
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

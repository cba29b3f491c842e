// A place in a text, and errors that tell it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "minksum/io.hpp"

namespace minksum::io {

[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] inline bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
[[nodiscard]] inline bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f';
}

class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {}

  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }
  /// The character here; NUL at the end (a NUL in the text is no character that any format knows).
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[position_]; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(position_); }
  void advance(std::size_t count = 1) { position_ += count; }
  void move_to(std::size_t position) { position_ = position; }

  void skip_space() {
    while (!at_end() && is_space(text_[position_])) ++position_;
  }
  /// Skips white space and `#` comments.
  void skip_space_and_comments();
  /// Takes `c` if it is here.
  bool accept(char c) {
    if (at_end() || text_[position_] != c) return false;
    ++position_;
    return true;
  }
  /// The run of letters here, in upper case; taken.
  std::string take_word();

  /// What stands here, for a message: a quoted word or character, a byte, or the end of the text.
  [[nodiscard]] std::string found() const;
  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t position,
                         const std::optional<ExceededLimit>& limit = {}) const;
  [[noreturn]] void fail(const std::string& message) const {
    fail(ErrorCode::kBadInput, message, position_);
  }
  [[noreturn]] void fail_expected(const std::string& what) const;

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

/// A limit on nesting, counted by whoever descends.
class DepthGuard {
 public:
  DepthGuard(const TextCursor& cursor, int& depth, int limit);
  ~DepthGuard() { --depth_; }
  DepthGuard(const DepthGuard&) = delete;
  DepthGuard& operator=(const DepthGuard&) = delete;

 private:
  int& depth_;
};

[[noreturn]] void fail_too_deep(const TextCursor& cursor, int limit);

}  // namespace minksum::io

// Keeps a position in a text or in bytes, and reports errors there.
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
  /// Says how errors name a place: by line and column, or by the number of the byte.
  enum class Counts { kLines, kBytes };
  explicit TextCursor(std::string_view text, Counts counts = Counts::kLines)
      : text_(text), counts_(counts) {}

  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }
  /// Returns the character here, or NUL at the end. No format knows a NUL, so the two do not clash.
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
  /// Passes over `c` if it stands here; returns whether it did.
  bool accept(char c) {
    if (at_end() || text_[position_] != c) return false;
    ++position_;
    return true;
  }
  /// Passes over the run of letters here, and returns it in upper case.
  std::string take_word();

  /// Describes for a message what stands here: a quoted word or character, a byte, or the end.
  [[nodiscard]] std::string found() const;
  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t position,
                         const std::optional<ExceededLimit>& limit = {}) const;
  [[noreturn]] void fail(const std::string& message) const {
    fail(ErrorCode::kBadInput, message, position_);
  }
  [[noreturn]] void fail_expected(const std::string& what) const;

  /// Makes messages begin with the name of a record, such as "feature 3: ", from now on. The kind
  /// must live as long as the cursor; if it is empty, they begin without a name.
  void name_record(std::string_view kind, std::size_t number) {
    record_ = kind;
    record_number_ = number;
  }

 private:
  std::string_view text_;
  Counts counts_;
  std::size_t position_ = 0;
  std::string_view record_;
  std::size_t record_number_ = 0;
};

/// Counts one level of nesting while it lives, and fails beyond the limit.
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

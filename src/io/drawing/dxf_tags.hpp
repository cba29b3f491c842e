// Declares a reader of DXF's tags: pairs of a line with a code and a line with a value.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "io/text_cursor.hpp"
#include "machine/cancellation.hpp"
#include "minksum/region.hpp"

namespace minksum::io {

struct DxfTag {
  int code = 0;
  std::size_t position = 0;  ///< of the value in the text
  std::string_view value;    ///< without white space around it
};

/// An entity: its type, and the tags behind it up to the next entity.
struct DxfEntity {
  DxfTag type;
  std::vector<DxfTag> tags;
};

class DxfTags {
 public:
  DxfTags(std::string_view text, Cancellation& cancellation)
      : cursor_(text), cancellation_(cancellation) {}

  [[nodiscard]] const TextCursor& cursor() const { return cursor_; }
  [[nodiscard]] std::size_t position() const { return cursor_.position(); }
  void move_to(std::size_t position) { cursor_.move_to(position); }

  /// Returns the next tag without comments. Fails at the end of the text.
  [[nodiscard]] DxfTag next();
  /// Reads the next entity, which must begin here. Stands before the entity behind it afterwards.
  void next(DxfEntity& entity);
  /// Returns the next tag, and stays before it.
  [[nodiscard]] DxfTag peek();

  /// Returns the number that a tag has as its value.
  [[nodiscard]] Rational number(const DxfTag& tag) const;
  [[nodiscard]] int integer(const DxfTag& tag) const;
  [[noreturn]] void fail(const std::string& message, std::size_t position) const {
    cursor_.fail(ErrorCode::kBadInput, message, position);
  }

 private:
  TextCursor cursor_;
  Cancellation& cancellation_;
};

/// Gives the values of an entity by their codes.
class DxfValues {
 public:
  DxfValues(const DxfTags& tags, const DxfEntity& entity) : tags_(tags), entity_(entity) {}

  [[nodiscard]] const DxfTag* find(int code) const {
    for (const DxfTag& tag : entity_.tags) {
      if (tag.code == code) return &tag;
    }
    return nullptr;
  }
  [[nodiscard]] std::string_view text(int code, std::string_view missing = {}) const {
    const DxfTag* const tag = find(code);
    return tag != nullptr ? tag->value : missing;
  }
  [[nodiscard]] int integer(int code, int missing = 0) const {
    const DxfTag* const tag = find(code);
    return tag != nullptr ? tags_.integer(*tag) : missing;
  }
  [[nodiscard]] Rational number(int code, const Rational& missing) const {
    const DxfTag* const tag = find(code);
    return tag != nullptr ? tags_.number(*tag) : missing;
  }
  /// Returns a number that must be there.
  [[nodiscard]] Rational number(int code) const;
  /// Returns the point of the codes `code` and `code` + 10, which must be there.
  [[nodiscard]] Point point(int code) const { return {number(code), number(code + 10)}; }

 private:
  const DxfTags& tags_;
  const DxfEntity& entity_;
};

}  // namespace minksum::io

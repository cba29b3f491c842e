// Builds the JSON values that the program writes, and answers a few questions about JSON texts.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

/// A JSON value to be written. Members of an object keep the order in which they were added.
class Json {
 public:
  Json() = default;  ///< null; the first element or member makes it an array or an object
  Json(std::nullptr_t) {}
  Json(bool value);
  Json(std::integral auto value) : text_(std::to_string(value)) {}
  Json(double value);  ///< null, if it is not finite
  /// Bytes that are not UTF-8 are replaced, because file names and messages may have any bytes.
  Json(std::string_view value);
  Json(const std::string& value) : Json(std::string_view(value)) {}
  Json(const char* value) : Json(std::string_view(value)) {}
  /// Makes an object if all values are pairs that start with a string, else an array.
  Json(std::initializer_list<Json> values);

  [[nodiscard]] static Json array() { return Json(Kind::kArray); }
  [[nodiscard]] static Json object() { return Json(Kind::kObject); }

  /// Returns the member of an object by its name. A missing member is added.
  Json& operator[](std::string_view key);
  /// Adds an element to an array.
  void push_back(Json value);
  /// Takes over all members of another object.
  void update(const Json& other);

  /// Returns the text: one line without spaces, or indented lines if `indent` is not 0.
  [[nodiscard]] std::string dump(std::size_t indent = 0) const;

 private:
  enum class Kind { kScalar, kArray, kObject };
  explicit Json(Kind kind) : kind_(kind) {}
  void write(std::string& out, std::size_t indent, std::size_t depth) const;
  Json& member(const std::string& key);

  Kind kind_ = Kind::kScalar;
  std::string text_ = "null";      // the text of a scalar
  std::vector<std::string> keys_;  // the keys of an object, as JSON
  std::vector<Json> values_;       // elements, or members by their keys
};

/// Returns whether the text is JSON whose numbers are all in the range of doubles.
[[nodiscard]] bool is_plain_json(std::string_view text);
/// Returns the value of `text`, which must be a string in JSON.
[[nodiscard]] std::string parse_json_string(std::string_view text);

}  // namespace minksum::cli

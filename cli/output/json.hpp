// JSON values: what the program writes, and the little that it asks about a text.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::cli {

/// A value that is made to be written. Members of an object keep the order in which they came.
class Json {
 public:
  Json() = default;  ///< null; the first element or member makes it an array or an object
  Json(std::nullptr_t) {}
  Json(bool value);
  Json(std::integral auto value) : text_(std::to_string(value)) {}
  Json(double value);  ///< null, if it is not finite
  /// What is not UTF-8 is replaced: names of files and messages may hold any bytes.
  Json(std::string_view value);
  Json(const std::string& value) : Json(std::string_view(value)) {}
  Json(const char* value) : Json(std::string_view(value)) {}
  /// An object, if all values are pairs whose first one is a string; else an array.
  Json(std::initializer_list<Json> values);

  [[nodiscard]] static Json array();
  [[nodiscard]] static Json object();

  /// The member of an object by this name; added, if there is none.
  Json& operator[](std::string_view key);
  /// Adds an element to an array.
  void push_back(Json value);
  /// Sets all members that another object has.
  void update(const Json& other);

  /// In one line without spaces; in lines that are indented, if `indent` is not 0.
  [[nodiscard]] std::string dump(std::size_t indent = 0) const;

 private:
  enum class Kind { kScalar, kArray, kObject };
  void write(std::string& out, std::size_t indent, std::size_t depth) const;
  Json& member(const std::string& key);

  Kind kind_ = Kind::kScalar;
  std::string text_ = "null";      // of a scalar
  std::vector<std::string> keys_;  // of an object, as JSON
  std::vector<Json> values_;       // elements, or members by their keys
};

/// Whether the text is JSON whose numbers doubles can hold.
[[nodiscard]] bool is_plain_json(std::string_view text);
/// The string that `text`, which is a string in JSON, is.
[[nodiscard]] std::string parse_json_string(std::string_view text);

}  // namespace minksum::cli

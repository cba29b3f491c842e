#include "output/json_members.hpp"

#include <algorithm>

#include "output/json.hpp"

namespace minksum::cli {
namespace {

// Returns whether the text is a number by the rules of JSON (RFC 8259, section 6).
bool is_number(std::string_view text) {
  const auto digits = [&text] {
    const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(count);
    return count;
  };
  const auto accept = [&text](std::string_view any_of) {
    const bool is_there = !text.empty() && any_of.find(text.front()) != std::string_view::npos;
    if (is_there) text.remove_prefix(1);
    return is_there;
  };
  accept("-");
  if (!accept("0") && digits() == 0) return false;
  if (accept(".") && digits() == 0) return false;
  if (accept("eE")) {
    accept("+-");
    if (digits() == 0) return false;
  }
  return text.empty();
}

// Returns whether the text is JSON. The library that tells refuses numbers beyond the range of
// doubles, so it gets a 0 instead of each number.
bool is_json(std::string_view text) {
  std::string simpler;
  simpler.reserve(text.size());
  bool in_string = false;
  while (!text.empty()) {
    const char c = text.front();
    std::size_t length = in_string && c == '\\' ? 2 : 1;
    if (c == '"') in_string = !in_string;
    const bool digit = c == '-' || (c >= '0' && c <= '9');
    if (!in_string && digit) length = text.find_first_not_of("+-.0123456789eE");
    const std::string_view part = text.substr(0, length);
    const bool is_replaced = !in_string && digit && is_number(part);
    simpler += is_replaced ? std::string_view("0") : part;
    text.remove_prefix(part.size());
  }
  return is_plain_json(simpler);
}

// Walks over a text, which must be valid JSON.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) { skip_space(); }

  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void take() {
    ++at_;
    skip_space();
  }
  // Returns the value here, and passes over it.
  std::string_view take_value() {
    const std::size_t begin = at_;
    if (peek() == '"') {
      skip_string();
    } else if (peek() == '{' || peek() == '[') {
      skip_nested();
    } else {
      at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    }
    const std::string_view value = text_.substr(begin, at_ - begin);
    skip_space();
    return value;
  }

 private:
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  void skip_string() {
    for (++at_; peek() != '"'; ++at_) {
      if (peek() == '\\') ++at_;
    }
    ++at_;
  }
  void skip_nested() {
    std::size_t depth = 0;
    do {
      const char c = peek();
      if (c == '"') {
        skip_string();
        continue;
      }
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      ++at_;
    } while (depth > 0);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<std::vector<JsonMember>> json_members(std::string_view text) {
  if (!is_json(text)) return {};
  Scanner scanner(text);
  if (scanner.peek() != '{') return {};
  std::vector<JsonMember> members;
  scanner.take();
  while (scanner.peek() != '}') {
    std::string key = parse_json_string(scanner.take_value());
    scanner.take();  // the colon
    members.push_back({std::move(key), scanner.take_value()});
    if (scanner.peek() == ',') scanner.take();
  }
  return members;
}

std::optional<std::vector<std::string_view>> json_elements(std::string_view text) {
  Scanner scanner(text);
  if (scanner.peek() != '[') return {};
  std::vector<std::string_view> elements;
  scanner.take();
  while (scanner.peek() != ']') {
    elements.push_back(scanner.take_value());
    if (scanner.peek() == ',') scanner.take();
  }
  return elements;
}

std::optional<std::string> json_string(std::string_view text) {
  if (Scanner(text).peek() != '"') return {};
  return parse_json_string(text);
}

std::string to_json(std::string_view text) { return Json(text).dump(); }

}  // namespace minksum::cli

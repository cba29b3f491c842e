// Only this file includes the library for JSON, because it takes long to compile.
#include "output/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace minksum::cli {

Json::Json(bool value) : text_(value ? "true" : "false") {}

Json::Json(double value) : text_(nlohmann::json(value).dump()) {}

Json::Json(std::string_view value)
    : text_(nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) {}

Json::Json(std::initializer_list<Json> values) : kind_(Kind::kArray) {
  const bool is_object = std::ranges::all_of(values, [](const Json& value) {
    return value.kind_ == Kind::kArray && value.values_.size() == 2 &&
           value.values_.front().text_.starts_with('"');
  });
  if (!is_object) {
    values_ = values;
    return;
  }
  kind_ = Kind::kObject;
  for (const Json& value : values) member(value.values_.front().text_) = value.values_.back();
}

Json& Json::operator[](std::string_view key) { return member(Json(key).text_); }

void Json::push_back(Json value) {
  kind_ = Kind::kArray;
  values_.push_back(std::move(value));
}

void Json::update(const Json& other) {
  for (std::size_t i = 0; i < other.keys_.size(); ++i) member(other.keys_[i]) = other.values_[i];
}

Json& Json::member(const std::string& key) {
  kind_ = Kind::kObject;
  const auto found = std::ranges::find(keys_, key);
  if (found != keys_.end()) return values_[static_cast<std::size_t>(found - keys_.begin())];
  keys_.push_back(key);
  return values_.emplace_back();
}

std::string Json::dump(std::size_t indent) const {
  std::string out;
  write(out, indent, 0);
  return out;
}

void Json::write(std::string& out, std::size_t indent, std::size_t depth) const {
  if (kind_ == Kind::kScalar) {
    out += text_;
    return;
  }
  const bool is_object = kind_ == Kind::kObject;
  const auto begin_line = [&](std::size_t level) {
    if (indent == 0 || values_.empty()) return;
    out += '\n';
    out.append(indent * level, ' ');
  };
  out += is_object ? '{' : '[';
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (i > 0) out += ',';
    begin_line(depth + 1);
    if (is_object) out.append(keys_[i]).append(indent == 0 ? ":" : ": ");
    values_[i].write(out, indent, depth + 1);
  }
  begin_line(depth);
  out += is_object ? '}' : ']';
}

bool is_plain_json(std::string_view text) { return nlohmann::json::accept(text); }

std::string parse_json_string(std::string_view text) {
  return nlohmann::json::parse(text).get<std::string>();
}

}  // namespace minksum::cli

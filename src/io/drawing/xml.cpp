#include "io/drawing/xml.hpp"

#include <algorithm>

namespace minksum::io {
namespace {

bool is_name(char c) {
  return is_letter(c) || is_digit(c) || c == ':' || c == '_' || c == '-' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::string_view take_name(TextCursor& cursor, const char* what) {
  const std::string_view rest = cursor.rest();
  std::size_t length = 0;
  while (length < rest.size() && is_name(rest[length])) ++length;
  if (length == 0) cursor.fail_expected(what);
  cursor.advance(length);
  return rest.substr(0, length);
}

}  // namespace

std::size_t length_of_declaration(std::string_view text) {
  int brackets = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = text.find(c, i + 1);
      if (i == std::string_view::npos) return i;
    } else if (c == '[') {
      ++brackets;
    } else if (c == ']') {
      --brackets;
    } else if (c == '>' && brackets <= 0) {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

XmlDocument::XmlDocument(std::string_view text, int max_depth, Cancellation& cancellation)
    : cursor_(text) {
  read(max_depth, cancellation);
  find_foreign_prefixes();
}

void XmlDocument::read(int max_depth, Cancellation& cancellation) {
  std::vector<std::size_t> open;
  bool begun = false;
  for (;;) {
    const std::size_t before = cursor_.position();
    cursor_.advance(std::min(cursor_.rest().find('<'), cursor_.rest().size()));
    cancellation.check(16 + (cursor_.position() - before) / 16);
    if (open.empty()) {
      const std::string_view between = cursor_.text().substr(before, cursor_.position() - before);
      const auto stray = std::find_if_not(between.begin(), between.end(), is_space);
      if (stray != between.end()) {
        cursor_.move_to(before + static_cast<std::size_t>(stray - between.begin()));
        cursor_.fail_expected(begun ? "the end of the text" : "an element");
      }
    }
    if (cursor_.at_end()) break;
    const std::string_view rest = cursor_.rest();
    if (rest.starts_with("<!") || rest.starts_with("<?")) {
      skip_markup();
    } else if (rest.starts_with("</")) {
      const std::size_t at = cursor_.position();
      cursor_.advance(2);
      const std::string_view name = take_name(cursor_, "the name of an element");
      if (open.empty()) cursor_.fail(ErrorCode::kBadInput, "an end tag without its begin", at);
      XmlElement& element = elements_[open.back()];
      TextCursor begin = cursor_;
      begin.move_to(element.position);
      if (const std::string_view begun_by = take_name(begin, ""); begun_by != name) {
        cursor_.fail(ErrorCode::kBadInput,
                     "expected the end tag of '" + std::string(begun_by.substr(0, 80)) +
                         "', found that of '" + std::string(name.substr(0, 80)) + "'",
                     at);
      }
      cursor_.skip_space();
      if (!cursor_.accept('>')) cursor_.fail_expected("'>'");
      element.next = elements_.size();
      element.end = at;
      open.pop_back();
    } else {
      if (open.empty() && begun) cursor_.fail("a document has one root element");
      begun = true;
      if (open.size() >= static_cast<std::size_t>(std::max(max_depth, 0))) {
        cursor_.fail(ErrorCode::kLimitExceeded,
                     "elements are nested deeper than the limit of " + std::to_string(max_depth),
                     cursor_.position(),
                     ExceededLimit{"io::ReadOptions::max_depth",
                                   static_cast<std::uint64_t>(std::max(max_depth, 0))});
      }
      cursor_.advance();
      elements_.push_back({cursor_.position(), elements_.size() + 1, 0});
      take_name(cursor_, "the name of an element");
      const bool empty = take_attributes(cursor_, nullptr);
      elements_.back().end = cursor_.position();
      if (!empty) open.push_back(elements_.size() - 1);
    }
  }
  if (!open.empty()) {
    TextCursor begin = cursor_;
    begin.move_to(elements_[open.back()].position);
    const std::string name(take_name(begin, ""));
    cursor_.fail(ErrorCode::kBadInput, "the element '" + name + "' has no end tag",
                 elements_[open.back()].position);
  }
  if (!begun) cursor_.fail_expected("an element");
}

void XmlDocument::skip_past(std::string_view end, const char* what) {
  const std::size_t found = cursor_.rest().find(end);
  if (found == std::string_view::npos) cursor_.fail(std::string(what) + " has no end");
  cursor_.advance(found + end.size());
}

void XmlDocument::skip_markup() {
  const std::string_view rest = cursor_.rest();
  if (rest.starts_with("<!--")) return skip_past("-->", "a comment");
  if (rest.starts_with("<![CDATA[")) return skip_past("]]>", "a CDATA section");
  if (rest.starts_with("<?")) return skip_past("?>", "a processing instruction");
  const std::size_t length = length_of_declaration(rest);
  if (length == std::string_view::npos) cursor_.fail("a declaration has no end");
  cursor_.advance(length);
}

bool XmlDocument::take_attributes(TextCursor& cursor, std::vector<XmlAttribute>* found) {
  for (;;) {
    const bool spaced = is_space(cursor.peek());
    cursor.skip_space();
    if (cursor.accept('>')) return false;
    if (cursor.accept('/')) {
      if (!cursor.accept('>')) cursor.fail_expected("'>'");
      return true;
    }
    if (!spaced) cursor.fail_expected("a space, '>' or '/>'");
    const std::string_view name = take_name(cursor, "the name of an attribute");
    cursor.skip_space();
    if (!cursor.accept('=')) cursor.fail_expected("'='");
    cursor.skip_space();
    const char quote = cursor.peek();
    if (quote != '"' && quote != '\'') cursor.fail_expected("a value in quotes");
    const std::size_t start = cursor.position();
    cursor.advance();
    const std::size_t length = cursor.rest().find(quote);
    if (length == std::string_view::npos) {
      cursor.fail(ErrorCode::kBadInput, "the value of an attribute has no end", start);
    }
    if (found != nullptr) {
      found->push_back({name, cursor.position(), cursor.rest().substr(0, length)});
    }
    cursor.advance(length + 1);
  }
}

std::string_view XmlDocument::name(std::size_t element) const {
  TextCursor cursor = cursor_;
  cursor.move_to(elements_[element].position);
  const std::string_view name = take_name(cursor, "");
  const std::size_t colon = name.rfind(':');
  if (colon == std::string_view::npos) return name;
  const bool is_foreign =
      std::find(foreign_.begin(), foreign_.end(), name.substr(0, colon)) != foreign_.end();
  return is_foreign ? name : name.substr(colon + 1);
}

void XmlDocument::find_foreign_prefixes() {
  const std::string declares = "xmlns:";
  TextCursor cursor = cursor_;
  cursor.move_to(elements_[0].position);
  const std::string_view root = take_name(cursor, "");
  const std::size_t colon = root.rfind(':');
  const std::string declaration =
      colon == std::string_view::npos ? "xmlns" : declares + std::string(root.substr(0, colon));
  const std::vector<XmlAttribute> all = attributes(0);
  std::string_view namespace_of_root;
  for (const XmlAttribute& attribute : all) {
    if (attribute.name == declaration) namespace_of_root = attribute.value;
  }
  for (const auto& [name, position, value] : all) {
    if (!name.starts_with(declares) || value == namespace_of_root) continue;
    foreign_.push_back(name.substr(declares.size()));
  }
}

std::vector<XmlAttribute> XmlDocument::attributes(std::size_t element) const {
  TextCursor cursor = cursor_;
  cursor.move_to(elements_[element].position);
  take_name(cursor, "");
  std::vector<XmlAttribute> found;
  take_attributes(cursor, &found);
  for (XmlAttribute& attribute : found) {
    if (attribute.value.find('&') == std::string_view::npos) continue;
    if (!references_) references_.emplace(cursor_.text().substr(0, elements_[0].position));
    attribute.value = references_->expanded(attribute.value);
  }
  return found;
}

TextCursor XmlDocument::cursor_on(const XmlAttribute& attribute) const {
  const std::string_view text = cursor_.text();
  const auto& [name, position, value] = attribute;
  const bool replaced = value.data() != text.data() + position;
  if (replaced) replaced_ = std::string(text.substr(0, position)).append(value);
  TextCursor cursor(replaced ? std::string_view(replaced_)
                             : text.substr(0, position + value.size()));
  cursor.move_to(position);
  return cursor;
}

std::string_view XmlDocument::content(std::size_t element) const {
  TextCursor cursor = cursor_;
  cursor.move_to(elements_[element].position);
  take_name(cursor, "");
  take_attributes(cursor, nullptr);
  const std::size_t from = cursor.position();
  const std::size_t end = elements_[element].end;
  return end > from ? cursor_.text().substr(from, end - from) : std::string_view();
}

}  // namespace minksum::io

#include "io/drawing/dxf_tags.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "io/number.hpp"

namespace minksum::io {

DxfTag DxfTags::next() {
  DxfTag tag;
  const auto take_line = [this](std::size_t& position) {
    const std::string_view rest = cursor_.rest();
    const std::string_view line = rest.substr(0, rest.find('\n'));
    cancellation_.check(8 + line.size() / 16);
    std::size_t begin = 0;
    std::size_t end = line.size();
    while (begin < end && is_space(line[begin])) ++begin;
    while (end > begin && is_space(line[end - 1])) --end;
    position = cursor_.position() + begin;
    cursor_.advance(std::min(line.size() + 1, rest.size()));
    return line.substr(begin, end - begin);
  };
  do {
    if (cursor_.at_end()) cursor_.fail_expected("a code, or the end of the drawing (EOF)");
    std::size_t at = 0;
    const std::string_view code = take_line(at);
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), tag.code);
    if (error != std::errc() || end != code.data() + code.size()) {
      cursor_.move_to(at);
      cursor_.fail_expected("the code of a value, an integer");
    }
    if (cursor_.at_end()) cursor_.fail_expected("the value of code " + std::to_string(tag.code));
    tag.value = take_line(tag.position);
  } while (tag.code == 999);
  return tag;
}

DxfTag DxfTags::peek() {
  const std::size_t here = cursor_.position();
  const DxfTag tag = next();
  cursor_.move_to(here);
  return tag;
}

void DxfTags::next(DxfEntity& entity) {
  entity.type = next();
  if (entity.type.code != 0) fail("expected an entity, whose code is 0", entity.type.position);
  entity.tags.clear();
  if (entity.type.value == "EOF") return;
  for (;;) {
    const std::size_t here = cursor_.position();
    const DxfTag tag = next();
    if (tag.code == 0) return cursor_.move_to(here);
    // Codes from 1000 on are data of other programs, and 102 begins such a group.
    if (tag.code < 1000) entity.tags.push_back(tag);
  }
}

Rational DxfTags::number(const DxfTag& tag) const {
  TextCursor cursor(cursor_.text().substr(0, tag.position + tag.value.size()));
  cursor.move_to(tag.position);
  const Rational value = scan_number(cursor, NumberSyntax::kPlain).value();
  if (!cursor.at_end()) cursor.fail_expected("the end of the number");
  return value;
}

int DxfTags::integer(const DxfTag& tag) const {
  int value = 0;
  const auto [end, error] =
      std::from_chars(tag.value.data(), tag.value.data() + tag.value.size(), value);
  if (error != std::errc() || end != tag.value.data() + tag.value.size()) {
    fail("expected an integer", tag.position);
  }
  return value;
}

Rational DxfValues::number(int code) const {
  const DxfTag* const tag = find(code);
  if (tag != nullptr) return tags_.number(*tag);
  tags_.fail(std::string(entity_.type.value.substr(0, 40)) + " has no value of code " +
                 std::to_string(code),
             entity_.type.position);
}

}  // namespace minksum::io

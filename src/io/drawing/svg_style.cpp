#include "io/drawing/svg_style.hpp"

#include <algorithm>

namespace minksum::io {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Calls visit(part) for the parts of a text between separators.
template <class Visit>
void for_each_part(std::string_view text, char separator, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    visit(trimmed(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void set(SvgStyle& style, std::string_view property, std::string_view value, Ignored& ignored) {
  value = trimmed(value.substr(0, value.find('!')));
  if (property == "display") {
    style.removed = style.removed || value == "none";
  } else if (property == "visibility") {
    if (value != "inherit") style.hidden = value != "visible";
  } else if (property == "fill") {
    if (value != "inherit") style.filled = value != "none" && value != "transparent";
  } else if (property == "fill-rule") {
    if (value != "inherit") style.even_odd = value == "evenodd";
  } else if (property == "clip-path" || property == "mask") {
    if (value != "none") ++ignored[std::string(property)];
  }
}

void set_all(SvgStyle& style, std::string_view declarations, Ignored& ignored) {
  for_each_part(declarations, ';', [&](std::string_view part) {
    const std::size_t colon = part.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view property = trimmed(part.substr(0, colon));
    if (property == "transform") {
      ++ignored["transform in a style"];
    } else {
      set(style, property, part.substr(colon + 1), ignored);
    }
  });
}

bool is_word(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || is_digit(c) || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

}  // namespace

void SvgStyles::add(std::string_view sheet, Ignored& ignored) {
  std::string text;
  while (!sheet.empty()) {  // without comments, and without the marks of a CDATA section
    const std::size_t comment = std::min(sheet.find("/*"), sheet.size());
    text += sheet.substr(0, comment);
    const std::size_t end = sheet.find("*/", comment);
    sheet.remove_prefix(end == std::string_view::npos ? sheet.size() : end + 2);
  }
  for (const std::string_view mark : {"<![CDATA[", "]]>", "<!--", "-->"}) {
    if (const std::size_t at = text.find(mark); at != std::string::npos)
      text.erase(at, mark.size());
  }
  for_each_part(text, '}', [&](std::string_view rule) {
    const std::size_t brace = rule.find('{');
    if (brace == std::string_view::npos) return;
    const std::string body(rule.substr(brace + 1));
    for_each_part(rule.substr(0, brace), ',', [&](std::string_view selector) {
      const std::size_t at = std::min(selector.find_first_of(".#"), selector.size());
      std::string_view tag = selector.substr(0, at);
      const std::string_view kind = selector.substr(std::min(at + 1, selector.size()));
      const char sign = at < selector.size() ? selector[at] : ' ';
      if (tag == "*") tag = {};
      if (is_word(tag) && is_word(kind)) {
        rules_.push_back({std::string(tag), std::string(kind), sign, body});
      } else {
        ++ignored["rule of a style sheet"];
      }
    });
  });
  // More special rules come later, because later ones win.
  std::stable_sort(rules_.begin(), rules_.end(), [](const Rule& a, const Rule& b) {
    const auto rank = [](const Rule& r) {
      return (r.sign == '#' ? 4 : r.sign == '.' ? 2 : 0) + (r.tag.empty() ? 0 : 1);
    };
    return rank(a) < rank(b);
  });
}

SvgStyle SvgStyles::style_of(SvgStyle style, std::string_view name,
                             const std::vector<XmlAttribute>& attributes, Ignored& ignored) const {
  std::string_view id, classes, own;
  for (const XmlAttribute& attribute : attributes) {
    if (attribute.name == "id") id = attribute.value;
    if (attribute.name == "class") classes = attribute.value;
    if (attribute.name == "style") own = attribute.value;
    set(style, attribute.name, attribute.value, ignored);
  }
  for (const Rule& rule : rules_) {
    if (!rule.tag.empty() && rule.tag != name) continue;
    bool meant = rule.sign == ' ' || (rule.sign == '#' && rule.kind == id);
    if (rule.sign == '.') {
      for_each_part(classes, ' ',
                    [&](std::string_view part) { meant = meant || part == rule.kind; });
    }
    if (meant) set_all(style, rule.text, ignored);
  }
  set_all(style, own, ignored);
  return style;
}

}  // namespace minksum::io

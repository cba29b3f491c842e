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

/// Calls visit(word) for what stands between spaces.
template <class Visit>
void for_each_word(std::string_view text, Visit visit) {
  while (!(text = trimmed(text)).empty()) {
    const auto end = std::find_if(text.begin(), text.end(), is_space);
    const auto length = static_cast<std::size_t>(end - text.begin());
    visit(text.substr(0, length));
    text.remove_prefix(length);
  }
}

/// Tells whether a text is the word, which has small letters, in small letters or capitals.
bool is(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// Properties by which style sheets may move and size shapes.
constexpr std::string_view kGeometry[] = {
    "transform", "transform-origin", "d", "x", "y", "width", "height", "cx", "cy", "r", "rx", "ry"};

void set(SvgStyle& style, std::string_view property, std::string_view value, Ignored& ignored) {
  if (is(value, "inherit")) return;
  if (is(property, "display")) {
    style.removed = is(value, "none");
  } else if (is(property, "visibility")) {
    if (is(value, "visible")) style.hidden = false;
    if (is(value, "hidden") || is(value, "collapse")) style.hidden = true;
  } else if (is(property, "fill")) {
    style.filled = !is(value, "none") && !is(value, "transparent");
  } else if (is(property, "fill-rule")) {
    if (is(value, "nonzero")) style.even_odd = false;
    if (is(value, "evenodd")) style.even_odd = true;
  } else if (is(property, "clip-path") || is(property, "mask")) {
    if (!is(value, "none")) ++ignored[std::string(property)];
  }
}

/// Sets what the declarations say, either the important ones or the others.
void set_all(SvgStyle& style, std::string_view declarations, bool important, Ignored& ignored) {
  for_each_part(declarations, ';', [&](std::string_view part) {
    const std::size_t colon = part.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view property = trimmed(part.substr(0, colon));
    const std::string_view rest = part.substr(colon + 1);
    const std::size_t mark = std::min(rest.find('!'), rest.size());
    if ((mark < rest.size()) != important) return;
    if (std::any_of(std::begin(kGeometry), std::end(kGeometry),
                    [&](std::string_view name) { return is(property, name); })) {
      ++ignored[std::string(property) + " in a style"];
    } else {
      set(style, property, trimmed(rest.substr(0, mark)), ignored);
    }
  });
}

std::string without_comments(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const std::size_t comment = std::min(text.find("/*"), text.size());
    kept += text.substr(0, comment);
    const std::size_t end = text.find("*/", comment);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  }
  return kept;
}

/// Returns a style sheet without the rules that begin with '@', and without what these hold.
std::string without_conditional_rules(std::string_view sheet, Ignored& ignored) {
  std::string kept;
  while (!sheet.empty()) {
    const std::size_t at = std::min(sheet.find('@'), sheet.size());
    kept += sheet.substr(0, at);
    if (at == sheet.size()) break;
    ++ignored["rule of a style sheet"];
    std::size_t end = std::min(sheet.find_first_of(";{", at), sheet.size());
    for (int open = 0; end < sheet.size(); ++end) {
      if (sheet[end] == '{') ++open;
      if (sheet[end] == '}') --open;
      if (open == 0) break;
    }
    sheet.remove_prefix(std::min(end + 1, sheet.size()));
  }
  return kept;
}

bool is_word(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || is_digit(c) || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

}  // namespace

void SvgStyles::add(std::string_view sheet, Ignored& ignored) {
  std::string text = without_comments(sheet);  // and without the marks of a CDATA section
  for (const std::string_view mark : {"<![CDATA[", "]]>", "<!--", "-->"}) {
    if (const std::size_t at = text.find(mark); at != std::string::npos)
      text.erase(at, mark.size());
  }
  for_each_part(without_conditional_rules(text, ignored), '}', [&](std::string_view rule) {
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
        const std::size_t weight = (sign == '#'   ? 4U
                                    : sign == '.' ? 2U
                                                  : 0U) +
                                   (tag.empty() ? 0U : 1U);
        rules_[weight].push_back({std::string(tag), std::string(kind), sign, body});
      } else {
        ++ignored["rule of a style sheet"];
      }
    });
  });
}

SvgStyle SvgStyles::style_of(SvgStyle style, std::string_view name,
                             const std::vector<XmlAttribute>& attributes, Ignored& ignored) const {
  std::string_view id, classes;
  std::string own;
  for (const XmlAttribute& attribute : attributes) {
    if (attribute.name == "id") id = attribute.value;
    if (attribute.name == "class") classes = attribute.value;
    if (attribute.name == "style") own = without_comments(attribute.value);
    set(style, attribute.name, trimmed(attribute.value), ignored);
  }
  for (const bool important : {false, true}) {
    for (const std::vector<Rule>& rules : rules_) {
      for (const Rule& rule : rules) {
        if (!rule.tag.empty() && rule.tag != name) continue;
        bool meant = rule.sign == ' ' || (rule.sign == '#' && rule.kind == id);
        if (rule.sign == '.') {
          for_each_word(classes,
                        [&](std::string_view word) { meant = meant || word == rule.kind; });
        }
        if (meant) set_all(style, rule.text, important, ignored);
      }
    }
    set_all(style, own, important, ignored);
  }
  return style;
}

}  // namespace minksum::io

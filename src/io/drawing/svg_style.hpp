// Declares what the appearance of SVG's elements says about their shapes.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/drawing/notes.hpp"
#include "io/drawing/xml.hpp"

namespace minksum::io {

/// The properties that matter here. Children inherit them.
struct SvgStyle {
  bool filled = true;
  bool even_odd = false;
  bool hidden = false;   ///< `visibility`: children may be visible
  bool removed = false;  ///< `display: none`, which holds for all children
};

/// The rules of a document's style sheets whose selectors are one name: `.a`, `#a`, `a`, `a.b`,
/// `*`.
class SvgStyles {
 public:
  /// Adds the rules of a `style` element. Others are counted in `ignored`.
  void add(std::string_view sheet, Ignored& ignored);
  /// Returns the style of an element inside of one with the style `inherited`.
  [[nodiscard]] SvgStyle style_of(SvgStyle inherited, std::string_view name,
                                  const std::vector<XmlAttribute>& attributes,
                                  Ignored& ignored) const;

 private:
  struct Rule {
    std::string tag;   ///< or "" for all
    std::string kind;  ///< a class, an id, or ""
    char sign;         ///< '.', '#', or ' '
    std::string text;
  };
  std::array<std::vector<Rule>, 6> rules_;  ///< by weight: the later ones win
};

}  // namespace minksum::io

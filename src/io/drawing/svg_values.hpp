// Declares readers of the small languages in SVG's attributes.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "io/drawing/near_affine.hpp"
#include "io/drawing/outlines.hpp"
#include "io/drawing/xml.hpp"

namespace minksum::io {

/// A length with its unit, which is "" or "px" for the unit of the user.
struct Length {
  Rational value;
  std::string_view unit;
};

/// Passes over white space and one comma.
void skip_comma(TextCursor& cursor);
/// Reads one number.
[[nodiscard]] Rational take_number(TextCursor& cursor);
/// Reads numbers up to the end.
[[nodiscard]] std::vector<Rational> take_numbers(TextCursor cursor);
/// Reads a length.
[[nodiscard]] Length take_length(TextCursor cursor);
/// Returns how many times a millimetre an absolute unit is: mm, cm, in, pt, pc, Q. Nothing for px
/// and for any other unit.
[[nodiscard]] std::optional<Rational> millimetres(std::string_view unit);
/// Reads the list of transformations in an element's `transform`, whose fixed point is its
/// `transform-origin`. Returns nothing for an element without a `transform`.
[[nodiscard]] std::optional<NearAffine> take_transform(const XmlDocument& document,
                                                       std::span<const XmlAttribute> attributes);

/// Reads the commands of a path. Open parts of a filled path are closed, as SVG fills them, and
/// otherwise they are polylines.
void take_path(TextCursor cursor, bool filled, Outlines& outlines);

/// Adds an arc of an ellipse from one point to another one, as the command A of a path does. The
/// radii are made larger if they are too small.
void take_arc(const Point& from, const Point& to, Rational rx, Rational ry, const Rational& degrees,
              bool large, bool sweep, Outlines& outlines);

/// Adds a closed path of four straight pieces and four quarters of ellipses; pieces may be missing.
void add_rounded_box(const Point& low, const Point& high, const Rational& rx, const Rational& ry,
                     Outlines& outlines);

}  // namespace minksum::io

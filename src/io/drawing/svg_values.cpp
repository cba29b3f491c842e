#include "io/drawing/svg_values.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "io/number.hpp"

namespace minksum::io {

void skip_comma(TextCursor& cursor) {
  cursor.skip_space();
  if (cursor.accept(',')) cursor.skip_space();
}

Rational take_number(TextCursor& cursor) {
  return scan_number(cursor, NumberSyntax::kPlain).value();
}

std::vector<Rational> take_numbers(TextCursor cursor) {
  std::vector<Rational> numbers;
  cursor.skip_space();
  while (!cursor.at_end()) {
    numbers.push_back(take_number(cursor));
    skip_comma(cursor);
  }
  return numbers;
}

Length take_length(TextCursor cursor) {
  std::string_view text = cursor.text();
  const auto drop_last = [&](auto is_dropped) {
    const std::size_t before = text.size();
    while (text.size() > cursor.position() && is_dropped(text.back())) text.remove_suffix(1);
    return cursor.text().substr(text.size(), before - text.size());
  };
  drop_last(is_space);
  // The unit comes off first: in "1em" no exponent begins.
  const std::string_view unit = drop_last([](char c) { return is_letter(c) || c == '%'; });
  TextCursor number(text);
  number.move_to(cursor.position());
  number.skip_space();
  const Rational value = take_number(number);
  if (!number.at_end()) number.fail_expected("a unit");
  return {value, unit};
}

std::optional<Rational> millimetres(std::string_view unit) {
  const Rational inch(127, 5);
  if (unit == "mm") return Rational(1);
  if (unit == "cm") return Rational(10);
  if (unit == "in") return inch;
  if (unit == "pt") return inch / Rational(72);
  if (unit == "pc") return inch / Rational(6);
  if (unit == "Q") return Rational(1, 4);
  return {};
}

namespace {

/// Reads the numbers of one transformation, in parentheses.
std::vector<Rational> take_arguments(TextCursor& cursor) {
  cursor.skip_space();
  if (!cursor.accept('(')) cursor.fail_expected("'('");
  std::vector<Rational> numbers;
  for (cursor.skip_space(); !cursor.accept(')'); skip_comma(cursor)) {
    numbers.push_back(take_number(cursor));
  }
  return numbers;
}

NearAffine moved(const Rational& x, const Rational& y) { return {Affine::translation(x, y)}; }

NearAffine transform_of(const std::string& name, const std::vector<Rational>& a,
                        const TextCursor& cursor, std::size_t start) {
  const std::size_t n = a.size();
  if (name == "MATRIX" && n == 6) {
    return {Affine{a[0], a[2], a[4], a[1], a[3], a[5]}};
  }
  if (name == "TRANSLATE" && (n == 1 || n == 2)) return moved(a[0], n == 2 ? a[1] : Rational());
  if (name == "SCALE" && (n == 1 || n == 2)) {
    return {Affine{a[0], {}, {}, {}, n == 2 ? a[1] : a[0], {}}};
  }
  if (name == "ROTATE" && (n == 1 || n == 3)) {
    const NearAffine turn = NearAffine::rotation(a[0]);
    return n == 1 ? turn : moved(a[1], a[2]).after(turn).after(moved(-a[1], -a[2]));
  }
  if (name == "SKEWX" && n == 1) return NearAffine::skew_x(a[0]);
  if (name == "SKEWY" && n == 1) {
    const NearAffine exchange{Affine{{}, 1, {}, 1, {}, {}}};
    return exchange.after(NearAffine::skew_x(a[0])).after(exchange);
  }
  cursor.fail(ErrorCode::kBadInput,
              "expected matrix, translate, scale, rotate, skewX or skewY with its numbers", start);
}

NearAffine take_list(TextCursor cursor) {
  NearAffine result;
  cursor.skip_space();
  if (cursor.rest() == "none") return result;
  while (!cursor.at_end()) {
    const std::size_t start = cursor.position();
    const std::string name = cursor.take_word();
    if (name.empty()) cursor.fail_expected("a transformation");
    result = result.after(transform_of(name, take_arguments(cursor), cursor, start));
    skip_comma(cursor);
  }
  return result;
}

Point take_origin(TextCursor cursor) {
  if (cursor.rest().find_first_not_of("0123456789+-.eEpx, \t\r\n") != std::string_view::npos) {
    cursor.fail("transform-origin is read as two numbers of px alone");
  }
  Point origin;
  cursor.skip_space();
  for (Rational* const coordinate : {&origin.x, &origin.y}) {
    *coordinate = take_number(cursor);
    if (cursor.rest().starts_with("px")) cursor.advance(2);
    skip_comma(cursor);
  }
  if (!cursor.at_end()) cursor.fail_expected("two numbers");
  return origin;
}

}  // namespace

std::optional<NearAffine> take_transform(const XmlDocument& document,
                                         std::span<const XmlAttribute> attributes) {
  const auto find = [&](std::string_view name) {
    return std::find_if(attributes.begin(), attributes.end(),
                        [&](const XmlAttribute& a) { return a.name == name; });
  };
  const auto list = find("transform");
  if (list == attributes.end()) return {};
  const NearAffine own = take_list(document.cursor_on(*list));
  const auto origin = find("transform-origin");
  if (origin == attributes.end()) return own;
  const Point at = take_origin(document.cursor_on(*origin));
  return moved(at.x, at.y).after(own).after(moved(-at.x, -at.y));
}

void take_arc(const Point& from, const Point& to, Rational rx, Rational ry, const Rational& degrees,
              bool large, bool sweep, Outlines& outlines) {
  if (from == to) return;
  if (rx.sign() < 0) rx = -rx;
  if (ry.sign() < 0) ry = -ry;
  if (rx.sign() == 0 || ry.sign() == 0) return outlines.line_to(to);
  const Span half{Interval::of((to.x - from.x) / Rational(2)),
                  Interval::of((to.y - from.y) / Rational(2))};
  const Point exact{(to.x - from.x) / Rational(2), (to.y - from.y) / Rational(2)};
  const Interval wide = Interval::of(rx / ry);
  const Interval high = Interval::of(ry / rx);
  // By the ellipse's axes, a quarter turn maps (x, y) to (-y·rx/ry, x·ry/rx), and `square` is the
  // squared half chord of the unit circle.
  Span turned{-(half.y * wide), half.x * high};
  Interval square;
  bool is_half = false;
  const Rational eighth = degrees / Rational(90);
  if (rx == ry || eighth.is_integer()) {
    const bool across = rx != ry && !(eighth / Rational(2)).is_integer();
    if (across) turned = {-(half.y * high), half.x * wide};
    const Rational x = exact.x / (across ? ry : rx);
    const Rational y = exact.y / (across ? rx : ry);
    const Rational exact_square = x * x + y * y;
    is_half = exact_square >= Rational(1);
    square = Interval::of(exact_square);
  } else {
    const Span axis = direction_of(
        Interval::of(degrees) * Interval::widened(std::numbers::pi / 180, std::numbers::pi / 180));
    const Interval x = axis.x * half.x + axis.y * half.y;
    const Interval y = axis.x * half.y - axis.y * half.x;
    const Interval along = -(y * wide);
    const Interval up = x * high;
    turned = {axis.x * along - axis.y * up, axis.y * along + axis.x * up};
    const Interval unit_x = x / Interval::of(rx);
    const Interval unit_y = y / Interval::of(ry);
    square = unit_x * unit_x + unit_y * unit_y;
    is_half = square.low >= 1;
  }
  Interval bulge(1);
  if (!is_half) {
    square.high = std::min(square.high, 1.0);
    const Interval sine = square_root(square);
    const Interval rest = Interval(1) + square_root(Interval(1) - square);
    bulge = large ? rest / sine : sine / rest;
  }
  outlines.arc_to(to, half, turned, sweep ? bulge : -bulge);
}

void add_rounded_box(const Point& low, const Point& high, const Rational& rx, const Rational& ry,
                     Outlines& outlines) {
  // Corners in the order in which they are passed, with the signs of their quarters of an ellipse.
  struct Corner {
    const Rational& x;
    const Rational& y;
    int right, down;
  };
  const std::array<Corner, 4> corners = {{{high.x, low.y, 1, -1},
                                          {high.x, high.y, 1, 1},
                                          {low.x, high.y, -1, 1},
                                          {low.x, low.y, -1, -1}}};
  const Interval bulge = square_root(Interval(2)) - Interval(1);
  const bool round = rx.sign() > 0 && ry.sign() > 0;
  Point at{low.x + rx, low.y};
  if (!round) at = low;
  outlines.move_to(at);
  const auto line_to = [&](const Point& to) {
    if (!(to == at)) outlines.line_to(to);
    at = to;
  };
  for (const auto& [x, y, right, down] : corners) {
    if (!round) {
      line_to({x, y});
      continue;
    }
    const Point centre{x - Rational(right) * rx, y - Rational(down) * ry};
    // A quarter goes from one axis to the next one, clockwise as the picture is seen.
    const bool from_x_axis = right == down;
    const Point u = from_x_axis ? Point{Rational(right) * rx, {}} : Point{{}, Rational(down) * ry};
    const Point v = from_x_axis ? Point{{}, Rational(down) * ry} : Point{Rational(right) * rx, {}};
    line_to({centre.x + u.x, centre.y + u.y});
    const auto halved = [](const Rational& value) { return Interval::of(value / Rational(2)); };
    at = {centre.x + v.x, centre.y + v.y};
    outlines.arc_to(at, {halved(v.x - u.x), halved(v.y - u.y)},
                    {halved(-u.x - v.x), halved(-u.y - v.y)}, bulge);
  }
  outlines.end_ring();
}

}  // namespace minksum::io

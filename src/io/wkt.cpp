// Reads and writes well-known text: polygons, lines, points, several of each, and collections.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include "io/formats.hpp"
#include "io/nested_writer.hpp"
#include "io/number.hpp"

namespace minksum::io {

namespace {

class WktReader {
 public:
  WktReader(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder)
      : cursor_(cursor), options_(options), builder_(builder) {}

  void read() {
    srid();
    geometry();
  }

 private:
  // PostGIS writes a prefix such as `SRID=4326;`. Its numbers below 0 mean unknown, as 0 does.
  void srid() {
    cursor_.skip_space();
    if (cursor_.peek() != 'S' && cursor_.peek() != 's') return;
    const std::size_t start = cursor_.position();
    if (cursor_.take_word() != "SRID") {
      cursor_.move_to(start);
      return;
    }
    if (!cursor_.accept('=')) cursor_.fail_expected("'=' after SRID");
    const std::size_t place = cursor_.position();
    const bool negative = cursor_.accept('-');
    const std::size_t number = scan_count(cursor_, "the number of the reference system");
    if (number > std::numeric_limits<std::int32_t>::max()) {
      cursor_.fail(ErrorCode::kBadInput, "the number of a reference system has 31 bits", place);
    }
    if (!cursor_.accept(';')) cursor_.fail_expected("';' after the SRID");
    if (!negative) builder_.set_srid(static_cast<std::int32_t>(number), place);
  }

  void geometry() {
    cursor_.skip_space();
    const std::size_t start = cursor_.position();
    std::string word = cursor_.take_word();
    const std::string dimension = take_dimension(word);
    if (!dimension.empty() && !options_.drop_z) {
      cursor_.fail(ErrorCode::kBadInput, word + ' ' + dimension + more_than_two(), start);
    }
    coordinates_ = dimension.empty() ? 0 : 2 + dimension.size();
    if (word == "GEOMETRYCOLLECTION") {
      const DepthGuard guard(cursor_, depth_, options_.max_depth);
      if (!accept_empty()) list([this] { geometry(); });
    } else if (!areas(word) && (builder_.rules() == Rules::kRegion || !thin_parts(word))) {
      cursor_.move_to(start);
      fail_other(word);
    }
  }

  // `areas` and `thin_parts` return whether they know the word; if so, they read what follows it.
  bool areas(const std::string& word) {
    if (word == "POLYGON") {
      maybe_empty([this] { polygon(); });
    } else if (word == "MULTIPOLYGON") {
      maybe_empty([this] { list([this] { maybe_empty([this] { polygon(); }); }); });
    } else {
      return false;
    }
    return true;
  }

  bool thin_parts(const std::string& word) {
    if (word == "POINT") {
      maybe_empty([this] { point_in_parentheses(); });
    } else if (word == "MULTIPOINT") {
      maybe_empty([this] { list([this] { maybe_empty([this] { multipoint_member(); }); }); });
    } else if (word == "LINESTRING" || word == "LINEARRING") {  // so GEOS writes a ring by itself
      maybe_empty([this] { line(); });
    } else if (word == "MULTILINESTRING") {
      maybe_empty([this] { list([this] { maybe_empty([this] { line(); }); }); });
    } else {
      return false;
    }
    return true;
  }

  // Takes Z, M or ZM from the end of the word, or from behind it.
  std::string take_dimension(std::string& word) {
    for (const std::string_view dimension : {"ZM", "Z", "M"}) {
      if (!word.ends_with(dimension)) continue;
      const std::string_view type =
          std::string_view(word).substr(0, word.size() - dimension.size());
      if (std::ranges::find(kWktTypes, type) == kWktTypes.end()) continue;
      word.resize(type.size());
      return std::string(dimension);
    }
    cursor_.skip_space();
    if (cursor_.peek() == '(') return {};  // nearly always
    const std::size_t start = cursor_.position();
    std::string next = cursor_.take_word();
    if (next == "Z" || next == "M" || next == "ZM") return next;
    cursor_.move_to(start);
    return {};
  }

  [[noreturn]] void fail_other(const std::string& word) {
    for (const char* thin :
         {"POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "LINEARRING"}) {
      if (word == thin) cursor_.fail("a region needs polygons: " + word + " has no area");
    }
    constexpr std::array<std::string_view, 9> kOthers = {
        "CURVE",        "COMPOUNDCURVE", "MULTICURVE", "CIRCULARSTRING",   "CURVEPOLYGON",
        "MULTISURFACE", "TRIANGLE",      "TIN",        "POLYHEDRALSURFACE"};
    for (const std::string_view other : kOthers) {
      if (word == other) cursor_.fail(word + " is not supported");
    }
    check_depth_here();
    cursor_.fail_expected(builder_.rules() == Rules::kRegion
                              ? "POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION"
                              : "POLYGON, LINESTRING, POINT, MULTI... or GEOMETRYCOLLECTION");
  }

  bool accept_empty() {
    cursor_.skip_space();
    if (cursor_.peek() == '(') return false;  // nearly always
    const std::size_t start = cursor_.position();
    if (cursor_.take_word() == "EMPTY") return true;
    cursor_.move_to(start);
    return false;
  }

  // If a run of opening brackets in a wrong place is too deep, the error says so.
  void check_depth_here() {
    int depth = depth_;
    for (const char c : cursor_.rest()) {
      if (is_space(c)) continue;
      if (c != '(') return;
      if (++depth > options_.max_depth) fail_too_deep(cursor_, options_.max_depth);
    }
  }

  // Reads '(' item ',' item ... ')'.
  template <typename Item>
  void list(Item item) {
    cursor_.skip_space();
    if (!cursor_.accept('(')) cursor_.fail_expected("'(' or EMPTY");
    do {
      item();
      cursor_.skip_space();
    } while (cursor_.accept(','));
    if (!cursor_.accept(')')) cursor_.fail_expected("',' or ')'");
  }

  template <typename Content>
  void maybe_empty(Content content) {
    if (!accept_empty()) content();
  }

  void polygon() {
    builder_.begin_polygon();
    list([this] { ring(); });
  }

  void ring() {
    cursor_.skip_space();
    builder_.begin_closed_ring();
    if (accept_empty()) cursor_.fail("a ring may not be EMPTY");
    list([this] {
      auto [x, y] = position();
      builder_.add_to_closed_ring(std::move(x), std::move(y));
    });
    builder_.end_closed_ring();
  }

  void line() {
    cursor_.skip_space();
    builder_.begin_line();
    list([this] {
      const auto [x, y] = position();
      builder_.add_to_line(x, y);
    });
    builder_.end_line();
  }

  void point() {
    const auto [x, y] = position();
    builder_.add_point(x, y);
  }

  void point_in_parentheses() {
    cursor_.skip_space();
    if (!cursor_.accept('(')) cursor_.fail_expected("'(' or EMPTY");
    point();
    cursor_.skip_space();
    if (!cursor_.accept(')')) cursor_.fail_expected("')'");
  }

  // Files have both `(1 2), (3 4)` and `1 2, 3 4`.
  void multipoint_member() {
    cursor_.skip_space();
    if (cursor_.peek() == '(') {
      point_in_parentheses();
    } else {
      point();
    }
  }

  Number coordinate() {
    if (cursor_.peek() == '(') check_depth_here();
    return scan_number(cursor_, NumberSyntax::kLenient);
  }

  std::pair<Number, Number> position() {
    cursor_.skip_space();
    Number x = coordinate();
    if (!is_space(cursor_.peek())) cursor_.fail_expected("a space and the second coordinate");
    cursor_.skip_space();
    Number y = coordinate();
    const char next = cursor_.peek();
    if ((next == ',' || next == ')') && coordinates_ == 0) {  // nearly always
      coordinates_ = 2;
    } else if (coordinates_ != 2 || (next != ',' && next != ')')) {
      further_coordinates();
    }
    return {std::move(x), std::move(y)};
  }

  // Passes over what a point has beyond x and y. All points of a geometry must have the same.
  void further_coordinates() {
    std::size_t count = 2;
    std::size_t place = cursor_.position();
    while (is_space(cursor_.peek())) {
      cursor_.skip_space();
      const char c = cursor_.peek();
      if (!is_digit(c) && !is_letter(c) && c != '-' && c != '+' && c != '.') break;
      place = cursor_.position();
      if (!options_.drop_z) cursor_.fail("a point" + more_than_two());
      if (++count > 4) cursor_.fail("a point has more than four coordinates");
      // Programs write heights that they do not know as NaN.
      if (!is_letter(c) || cursor_.take_word() != "NAN") {
        cursor_.move_to(place);
        static_cast<void>(scan_number(cursor_, NumberSyntax::kLenient));
      }
    }
    if (coordinates_ == 0) coordinates_ = count;
    if (count == coordinates_) return;
    cursor_.fail(ErrorCode::kBadInput,
                 "a point has " + std::to_string(count) + " coordinates, where " +
                     std::to_string(coordinates_) + " are expected",
                 place);
  }

  TextCursor& cursor_;
  const ReadOptions& options_;
  GeometryBuilder& builder_;
  int depth_ = 0;
  std::size_t coordinates_ = 0;  ///< of each point of this geometry; 0 = not known yet
};

// The OGC's standard puts parentheses around each point of a MULTIPOINT.
constexpr Notation kNotation{{"POLYGON ", "MULTIPOLYGON ", "LINESTRING ", "MULTILINESTRING ",
                              "POINT ", "MULTIPOINT ", "GEOMETRYCOLLECTION "},
                             "",
                             '(',
                             ')',
                             "EMPTY",
                             ' ',
                             true};

}  // namespace

void read_wkt(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder) {
  WktReader(cursor, options, builder).read();
}

void write_wkt(const Sink& out, const GeometryView& geometry, const Coordinates& style) {
  Writer writer(out, style);
  if (const auto srid = srid_of(style)) writer.text("SRID=" + std::to_string(*srid) + ";");
  write_nested(writer, geometry, kNotation);
  writer.flush();
}

}  // namespace minksum::io

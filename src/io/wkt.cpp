// Well-known text: polygons, multipolygons and collections of them.
#include <array>
#include <utility>

#include "io/formats.hpp"
#include "io/number.hpp"
#include "io/writer.hpp"

namespace minksum::io {

namespace {

class WktReader {
 public:
  WktReader(std::string_view text, const ReadLimits& limits)
      : cursor_(text), limits_(limits), builder_(region_) {}

  Region read() {
    skip_srid();
    geometry();
    cursor_.skip_space();
    if (!cursor_.at_end()) cursor_.fail_expected("the end of the text");
    return std::move(region_);
  }

 private:
  // `SRID=4326;`, as PostGIS writes it: it says nothing about the shape.
  void skip_srid() {
    cursor_.skip_space();
    const std::size_t start = cursor_.position();
    if (cursor_.take_word() != "SRID") {
      cursor_.move_to(start);
      return;
    }
    if (!cursor_.accept('=')) cursor_.fail_expected("'=' after SRID");
    cursor_.accept('-');
    static_cast<void>(scan_count(cursor_, "the number of the reference system"));
    if (!cursor_.accept(';')) cursor_.fail_expected("';' after the SRID");
  }

  void geometry() {
    cursor_.skip_space();
    const std::size_t start = cursor_.position();
    std::string word = cursor_.take_word();
    const std::string dimension = take_dimension(word);
    if (!dimension.empty()) {
      cursor_.fail(ErrorCode::kBadInput,
                   word + ' ' + dimension + " is not supported: only two coordinates are", start);
    }
    if (word == "POLYGON") {
      if (!accept_empty()) polygon();
    } else if (word == "MULTIPOLYGON") {
      if (!accept_empty()) list([this] { multipolygon_member(); });
    } else if (word == "GEOMETRYCOLLECTION") {
      const DepthGuard guard(cursor_, depth_, limits_.max_depth);
      if (!accept_empty()) list([this] { geometry(); });
    } else {
      cursor_.move_to(start);
      fail_not_polygons(word);
    }
  }

  // Z, M or ZM after the word, or at its end.
  std::string take_dimension(std::string& word) {
    for (const char* type : {"POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION"}) {
      for (const char* dimension : {"Z", "M", "ZM"}) {
        if (word != std::string(type) + dimension) continue;
        word = type;
        return dimension;
      }
    }
    cursor_.skip_space();
    const std::size_t start = cursor_.position();
    std::string next = cursor_.take_word();
    if (next == "Z" || next == "M" || next == "ZM") return next;
    cursor_.move_to(start);
    return {};
  }

  [[noreturn]] void fail_not_polygons(const std::string& word) {
    constexpr std::array<std::string_view, 14> kOthers = {
        "POINT",        "LINESTRING",    "LINEARRING", "MULTIPOINT",       "MULTILINESTRING",
        "CURVE",        "COMPOUNDCURVE", "MULTICURVE", "CIRCULARSTRING",   "CURVEPOLYGON",
        "MULTISURFACE", "TRIANGLE",      "TIN",        "POLYHEDRALSURFACE"};
    for (const std::string_view other : kOthers) {
      if (word != other) continue;
      cursor_.fail("a region needs polygons: " + word + " operands are not supported yet");
    }
    check_depth_here();
    cursor_.fail_expected("POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
  }

  bool accept_empty() {
    cursor_.skip_space();
    const std::size_t start = cursor_.position();
    if (cursor_.take_word() == "EMPTY") return true;
    cursor_.move_to(start);
    return false;
  }

  // A run of opening brackets where none belongs: say that it is too deep if it is.
  void check_depth_here() {
    int depth = depth_;
    for (const char c : cursor_.rest()) {
      if (is_space(c)) continue;
      if (c != '(') return;
      if (++depth > limits_.max_depth) fail_too_deep(cursor_, limits_.max_depth);
    }
  }

  // '(' item ',' item ... ')'
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

  void multipolygon_member() {
    if (!accept_empty()) polygon();
  }

  void polygon() {
    builder_.begin_polygon();
    list([this] { ring(); });
  }

  void ring() {
    cursor_.skip_space();
    builder_.begin_ring(cursor_);
    if (accept_empty()) cursor_.fail("a ring may not be EMPTY");
    list([this] { point(); });
    builder_.end_ring(cursor_);
  }

  Number coordinate() {
    if (cursor_.peek() == '(') check_depth_here();
    return scan_number(cursor_, NumberSyntax::kLenient);
  }

  void point() {
    cursor_.skip_space();
    Number x = coordinate();
    if (!is_space(cursor_.peek())) cursor_.fail_expected("a space and the second coordinate");
    cursor_.skip_space();
    Number y = coordinate();
    builder_.add(std::move(x), std::move(y));
    const char next = cursor_.peek();
    if (next == ',' || next == ')') return;  // what follows nearly always
    cursor_.skip_space();
    const char after = cursor_.peek();
    if (is_space(next) && (is_digit(after) || after == '-' || after == '+' || after == '.')) {
      cursor_.fail("a point has three coordinates; only two are supported");
    }
  }

  TextCursor cursor_;
  const ReadLimits& limits_;
  Region region_;
  ClosedRingBuilder builder_;
  int depth_ = 0;
};

void append_polygon(Writer& writer, const Region& region, std::size_t polygon) {
  if (region.rings_of(polygon).empty()) return writer.text("EMPTY");
  writer.text('(');
  bool first_ring = true;
  for (const std::size_t ring : region.rings_of(polygon)) {
    writer.text(first_ring ? "(" : ", (");
    first_ring = false;
    const IndexRange vertices = region.vertices_of(ring);
    for (const std::size_t vertex : vertices) {
      writer.point(region, vertex, ' ');
      writer.text(", ");
    }
    if (!vertices.empty()) writer.point(region, vertices.front(), ' ');
    writer.text(')');
  }
  writer.text(')');
}

}  // namespace

Region read_wkt(std::string_view text, const ReadLimits& limits) {
  return WktReader(text, limits).read();
}

void write_wkt(std::ostream& out, const Region& region, const Coordinates& style) {
  Writer writer(out, style);
  const std::size_t count = region.polygon_count();
  if (region.empty()) {
    writer.text("POLYGON EMPTY");
  } else if (count == 1) {
    writer.text("POLYGON ");
    append_polygon(writer, region, 0);
  } else {
    writer.text("MULTIPOLYGON (");
    for (const std::size_t polygon : region.polygons()) {
      if (polygon > 0) writer.text(", ");
      append_polygon(writer, region, polygon);
    }
    writer.text(')');
  }
  writer.flush();
}

}  // namespace minksum::io

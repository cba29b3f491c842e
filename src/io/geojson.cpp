// Reads and writes GeoJSON (RFC 7946): all of its geometries, and features with them.
#include <optional>
#include <utility>

#include "io/formats.hpp"
#include "io/json_cursor.hpp"
#include "io/nested_writer.hpp"
#include "io/number.hpp"

namespace minksum::io {

namespace {

// Makes a name from the text fit for a message: one short line of ASCII.
std::string quoted(std::string_view name) {
  std::string result = "\"";
  for (const char c : name.substr(0, 40)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + '"';
}

constexpr std::size_t kAbsent = std::string_view::npos;

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view text, const ReadLimits& limits, Rules rules)
      : json_(text, limits.max_depth), builder_(json_.text(), limits, rules) {}

  Geometry read() {
    if (json_.peek() == '[') {
      json_.text().fail("expected a GeoJSON object with a member \"type\", found an array");
    }
    object(Expected::kAnything);
    json_.skip_space();
    if (!json_.text().at_end()) json_.text().fail_expected("the end of the text");
    return builder_.take();
  }

 private:
  enum class Expected { kAnything, kGeometry, kFeature };

  // Positions of one object's members, which may come in any order.
  struct Members {
    std::size_t start = 0;
    std::optional<std::string> type;
    std::size_t type_at = kAbsent;
    std::size_t coordinates = kAbsent;
    std::size_t geometries = kAbsent;
    std::size_t features = kAbsent;
    std::size_t geometry = kAbsent;
    bool content_read = false;
  };

  // If "type" comes first, the content is read where it stands. Otherwise the reader goes back for
  // it at the end of the object, and so passes over that content twice.
  void object(Expected expected) {
    Members members;
    members.start = json_.text().position();
    json_.object("'{'", [&](const std::string& name) { member(name, members, expected); });
    const std::size_t end = json_.text().position();
    if (!members.type) fail_at(members.start, "an object has no member \"type\"");
    check_type(members, expected);
    if (members.content_read) return;
    const std::size_t content = *content_of(members);
    if (content == kAbsent) {
      fail_at(members.start,
              "a " + *members.type + " has no member \"" + content_name(*members.type) + '"');
    }
    json_.text().move_to(content);
    read_content(*members.type);
    json_.text().move_to(end);
  }

  void member(const std::string& name, Members& members, Expected expected) {
    if (name == "type") {
      if (members.type) json_.text().fail("a second member \"type\"");
      if (json_.peek() != '"') json_.text().fail_expected("the type in quotes");
      members.type_at = json_.text().position();
      members.type = json_.take_string();
      return;
    }
    std::size_t* place = member_place(name, members);
    if (place == nullptr) return json_.skip_value();
    if (*place != kAbsent) json_.text().fail("a second member \"" + name + '"');
    *place = json_.text().position();
    if (members.type && name == content_name(*members.type)) {
      check_type(members, expected);
      read_content(*members.type);
      members.content_read = true;
    } else {
      json_.skip_value();
    }
  }

  static std::size_t* member_place(const std::string& name, Members& members) {
    if (name == "coordinates") return &members.coordinates;
    if (name == "geometries") return &members.geometries;
    if (name == "features") return &members.features;
    if (name == "geometry") return &members.geometry;
    return nullptr;
  }

  static std::string content_name(const std::string& type) {
    if (type == "GeometryCollection") return "geometries";
    if (type == "FeatureCollection") return "features";
    if (type == "Feature") return "geometry";
    return "coordinates";
  }

  static const std::size_t* content_of(Members& members) {
    return member_place(content_name(*members.type), members);
  }

  void check_type(const Members& members, Expected expected) {
    const std::string& type = *members.type;
    if (type == "Feature" || type == "FeatureCollection") {
      const bool fits =
          expected == Expected::kAnything || (expected == Expected::kFeature && type == "Feature");
      if (!fits) fail_at(members.type_at, "a " + type + " may not stand here");
      return;
    }
    if (expected == Expected::kFeature) {
      fail_at(members.type_at, "expected a Feature, found the type " + quoted(type));
    }
    if (type == "Polygon" || type == "MultiPolygon" || type == "GeometryCollection") return;
    for (const char* thin : {"Point", "MultiPoint", "LineString", "MultiLineString"}) {
      if (type != thin) continue;
      if (builder_.rules() == Rules::kGeometry) return;
      fail_at(members.type_at, "a region needs polygons: " + type + " has no area");
    }
    fail_at(members.type_at, "unknown type " + quoted(type));
  }

  void read_content(const std::string& type) {
    if (json_.peek() == 'n') fail_null(type);
    if (type == "Polygon") {
      polygon();
    } else if (type == "MultiPolygon") {
      json_.array("an array of polygons", [this] { polygon(); });
    } else if (type == "Point") {
      point();
    } else if (type == "MultiPoint") {
      json_.array("an array of positions", [this] { add_point(); });
    } else if (type == "LineString") {
      line();
    } else if (type == "MultiLineString") {
      json_.array("an array of lines", [this] { line(); });
    } else if (type == "Feature") {
      object(Expected::kGeometry);
    } else if (type == "FeatureCollection") {
      json_.array("an array of features", [this] { object(Expected::kFeature); });
    } else {
      json_.array("an array of geometries", [this] { object(Expected::kGeometry); });
    }
  }

  [[noreturn]] void fail_null(const std::string& type) {
    if (!json_.text().rest().starts_with("null")) json_.text().fail_expected("a JSON value");
    json_.text().fail("the " + content_name(type) + " of a " + type + " is null");
  }

  void polygon() {
    bool any = false;
    json_.array("an array of rings", [&] {
      if (!any) builder_.begin_polygon();
      any = true;
      ring();
    });
  }

  void ring() {
    builder_.begin_closed_ring();
    json_.array("an array of positions", [this] {
      auto [x, y] = position();
      builder_.add_to_closed_ring(std::move(x), std::move(y));
    });
    builder_.end_closed_ring();
  }

  void line() {
    builder_.begin_line();
    json_.array("an array of positions", [this] {
      const auto [x, y] = position();
      builder_.add_to_line(x, y);
    });
    builder_.end_line();
  }

  void add_point() {
    const auto [x, y] = position();
    builder_.add_point(x, y);
  }

  // Accepts `[]`, which is the empty point.
  void point() {
    const std::size_t start = json_.text().position();
    if (json_.accept('[') && json_.accept(']')) return;
    json_.text().move_to(start);
    add_point();
  }

  std::pair<Number, Number> position() {
    json_.expect('[', "a position [x, y]");
    Number x = coordinate();
    json_.expect(',', "',' and the second coordinate");
    Number y = coordinate();
    if (json_.peek() == ',') {
      json_.text().fail("a position has three coordinates; only two are supported");
    }
    json_.expect(']', "']'");
    return {std::move(x), std::move(y)};
  }

  // Takes a JSON number, or any number in quotes, such as "1/3".
  Number coordinate() {
    if (json_.peek() != '"') {
      const char c = json_.text().peek();
      if (c == '[') json_.text().fail("expected a number, found '[': arrays are nested too deep");
      return scan_number(json_.text(), NumberSyntax::kJson);
    }
    json_.text().advance();
    Number number = scan_number(json_.text(), NumberSyntax::kLenient);
    if (!json_.text().accept('"')) json_.text().fail_expected("'\"' after the number");
    return number;
  }

  [[noreturn]] void fail_at(std::size_t position, const std::string& message) {
    json_.text().fail(ErrorCode::kBadInput, message, position);
  }

  JsonCursor json_;
  GeometryBuilder builder_;
};

constexpr Notation kNotation{
    {R"({"type": "Polygon", "coordinates": )", R"({"type": "MultiPolygon", "coordinates": )",
     R"({"type": "LineString", "coordinates": )", R"({"type": "MultiLineString", "coordinates": )",
     R"({"type": "Point", "coordinates": )", R"({"type": "MultiPoint", "coordinates": )",
     R"({"type": "GeometryCollection", "geometries": )"},
    "}",
    '[',
    ']',
    "[]",
    ',',
    false};

}  // namespace

Geometry read_geojson(std::string_view text, const ReadLimits& limits, Rules rules) {
  return GeoJsonReader(text, limits, rules).read();
}

void write_geojson(std::ostream& out, const GeometryView& geometry, const Coordinates& style) {
  Writer writer(out, style);
  writer.quote_quotients();
  write_nested(writer, geometry, kNotation);
  writer.flush();
}

}  // namespace minksum::io

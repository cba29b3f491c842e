// Reads and writes GeoJSON (RFC 7946): all of its geometries, and features with them.
#include <optional>
#include <utility>

#include "io/feature_source.hpp"
#include "io/formats.hpp"
#include "io/json_cursor.hpp"
#include "io/nested_writer.hpp"
#include "io/number.hpp"

namespace minksum::io {

namespace {

// Makes a name from the text fit for a message: one short line of ASCII.
std::string in_quotes(std::string_view name) {
  std::string result = "\"";
  for (const char c : name.substr(0, 40)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + '"';
}

constexpr std::size_t kAbsent = std::string_view::npos;

// Reads a text of one object, or of several, which lines or marks (RFC 8142) separate.
class GeoJsonSource : public FeatureSource {
 public:
  GeoJsonSource(std::string_view text, const ReadOptions& options, Rules rules)
      : FeatureSource(options, rules), json_(text, options.max_depth), drop_z_(options.drop_z) {
    builder_.follow(json_.text());
  }

  [[nodiscard]] std::string properties() const override { return std::string(properties_); }
  [[nodiscard]] std::string id() const override { return std::string(id_); }

 private:
  enum class Expected { kAnything, kGeometry, kFeature };
  static constexpr char kMark = '\x1E';  // before each object of a text sequence

  bool read_next() override {
    properties_ = id_ = {};
    for (;;) {
      if (in_collection_) {
        if (feature_of_collection()) return true;
      } else {
        if (!next_object()) return false;
        if (!in_collection_) return true;
      }
    }
  }

  // Reads the next object of the text. Stops at the features of a FeatureCollection.
  bool next_object() {
    if (!separator()) return false;
    if (json_.peek() == '[') {
      json_.text().fail("expected a GeoJSON object with a member \"type\", found an array");
    }
    if (objects_++ > 0) name_feature();
    begin_feature_here();
    collection_ = {};
    collection_.start = json_.text().position();
    json_.enter('{', "'{'");
    go_on_with_object();
    return true;
  }

  // Returns whether another object follows.
  bool separator() {
    bool separated = objects_ == 0;
    for (;; json_.text().advance()) {
      const char c = json_.text().peek();
      if (c == '\n' || c == kMark) separated = true;
      if (c != kMark && c != ' ' && c != '\n' && c != '\r' && c != '\t') break;
    }
    if (json_.text().at_end() && objects_ > 0) return false;
    if (!separated) json_.text().fail_expected("the end of the line or of the text");
    return true;
  }

  // Reads the object of the text to its end, or to the features that it has.
  void go_on_with_object() {
    if (members(collection_, Expected::kAnything)) return begin_features();
    const std::size_t end = json_.text().position();
    if (!finish(collection_, Expected::kAnything)) return;
    after_features_ = end;
    begin_features();
  }

  void begin_features() {
    json_.enter('[', "an array of features");
    in_collection_ = first_ = true;
  }

  // Reads the next feature. After the last one it reads the rest of the collection.
  bool feature_of_collection() {
    if (json_.next_item(first_, ']')) {
      name_feature();
      begin_feature_here();
      object(Expected::kFeature);
      return true;
    }
    in_collection_ = false;
    json_.text().name_record({}, 0);
    if (after_features_ != kAbsent) {
      json_.text().move_to(std::exchange(after_features_, kAbsent));
    } else {
      collection_.content_read = true;
      collection_.first = false;
      go_on_with_object();
    }
    return false;
  }

  void name_feature() { json_.text().name_record("feature", builder_.source().features + 1); }

  void begin_feature_here() {
    json_.skip_space();
    start_ = json_.text().position();
  }

  // Positions of one object's members, which may come in any order.
  struct Members {
    std::size_t start = 0;
    std::optional<std::string> type;
    std::size_t type_at = kAbsent;
    std::size_t coordinates = kAbsent;
    std::size_t geometries = kAbsent;
    std::size_t features = kAbsent;
    std::size_t geometry = kAbsent;
    std::string_view properties = "null";
    std::string_view id;
    bool first = true;  // no member has been read
    bool content_read = false;
    std::string other;  // names another format that has such members
  };

  // If "type" comes first, the content is read where it stands. Otherwise the reader goes back for
  // it at the end of the object, and so passes over that content twice.
  void object(Expected expected) {
    Members found;
    found.start = json_.text().position();
    json_.enter('{', "'{'");
    members(found, expected);
    finish(found, expected);
  }

  // Reads members to the end of the object. Returns true if it stops at the features of a
  // FeatureCollection, which are read one by one.
  bool members(Members& found, Expected expected) {
    while (json_.next_item(found.first, '}')) {
      if (member(json_.take_name(), found, expected)) return true;
    }
    return false;
  }

  // Reads the content of an object that was read to its end, if it stands before the type. Returns
  // true if it stops at features.
  bool finish(Members& found, Expected expected) {
    const std::size_t end = json_.text().position();
    if (!found.type) {
      fail_at(found.start, found.other.empty() ? "an object has no member \"type\"" : found.other);
    }
    check_type(found, expected);
    if (*found.type == "Feature") {
      properties_ = found.properties;
      id_ = found.id;
    }
    if (found.content_read) return false;
    const std::size_t content = *content_of(found);
    if (content == kAbsent) {
      fail_at(found.start,
              "a " + *found.type + " has no member \"" + content_name(*found.type) + '"');
    }
    json_.text().move_to(content);
    if (*found.type == "FeatureCollection") return true;
    read_content(*found.type);
    json_.text().move_to(end);
    return false;
  }

  bool member(const std::string& name, Members& found, Expected expected) {
    const std::size_t start = json_.text().position();
    if (name == "type") {
      if (found.type) json_.text().fail("a second member \"type\"");
      if (json_.peek() != '"') json_.text().fail_expected("the type in quotes");
      found.type_at = start;
      found.type = json_.take_string();
      return false;
    }
    std::size_t* place = member_place(name, found);
    if (place != nullptr && *place != kAbsent) {
      json_.text().fail("a second member \"" + name + '"');
    }
    if (place != nullptr) *place = start;
    if (place != nullptr && found.type && name == content_name(*found.type)) {
      check_type(found, expected);
      if (name == "features") return true;
      read_content(*found.type);
      found.content_read = true;
      return false;
    }
    if (!found.type && found.other.empty()) found.other = refusal_of_json(name);
    json_.skip_value();
    const std::string_view value =
        json_.text().text().substr(start, json_.text().position() - start);
    if (name == "properties") found.properties = value;
    if (name == "id") found.id = value;
    if (name == "crs" && value != "null") builder_.set_crs(value, start);
    return false;
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
      fail_at(members.type_at, "expected a Feature, found the type " + in_quotes(type));
    }
    if (type == "Polygon" || type == "MultiPolygon" || type == "GeometryCollection") return;
    for (const char* thin : {"Point", "MultiPoint", "LineString", "MultiLineString"}) {
      if (type != thin) continue;
      if (builder_.rules() == Rules::kGeometry) return;
      fail_at(members.type_at, "a region needs polygons: " + type + " has no area");
    }
    const std::string other = refusal_of_json(type);
    fail_at(members.type_at, other.empty() ? "unknown type " + in_quotes(type) : other);
  }

  void read_content(const std::string& type) {
    if (json_.peek() == 'n') return read_null(type);
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
    } else {
      json_.array("an array of geometries", [this] { object(Expected::kGeometry); });
    }
  }

  // A Feature may have no geometry, which `null` says (RFC 7946, section 3.2).
  void read_null(const std::string& type) {
    const std::size_t start = json_.text().position();
    json_.skip_value();
    if (type != "Feature")
      fail_at(start, "the " + content_name(type) + " of a " + type + " is null");
    is_null_ = true;
  }

  // Accepts `[[]]`, which GEOS writes for the empty polygon.
  void polygon() {
    const std::size_t start = json_.text().position();
    if (json_.accept('[') && json_.accept('[') && json_.accept(']') && json_.accept(']')) return;
    json_.text().move_to(start);
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
    while (json_.accept(',')) {
      if (!drop_z_) json_.text().fail("a position" + more_than_two());
      json_.skip_space();
      static_cast<void>(coordinate());
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
  bool drop_z_;
  std::size_t objects_ = 0;
  std::string_view properties_;
  std::string_view id_;
  Members collection_;                    // the object of the text
  bool in_collection_ = false;            // the cursor stands among its features
  bool first_ = true;                     // no feature of it has been read
  std::size_t after_features_ = kAbsent;  // where to go on, if the features stand before the type
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

std::unique_ptr<FeatureSource> geojson_source(std::string_view text, const ReadOptions& options,
                                              Rules rules) {
  return std::make_unique<GeoJsonSource>(text, options, rules);
}

void write_geojson(const Sink& out, const GeometryView& geometry, const Coordinates& style) {
  Writer writer(out, style);
  writer.quote_quotients();
  const std::string crs = crs_of(style);
  write_nested(writer, geometry, kNotation, crs.empty() ? "" : ", \"crs\": " + crs);
  writer.flush();
}

}  // namespace minksum::io

// Reads and writes well-known binary: that of the OGC and ISO, and PostGIS's extended form.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "io/formats.hpp"
#include "io/number.hpp"
#include "io/writer.hpp"
#include "machine/cancellation.hpp"

namespace minksum::io {

namespace {

// The kinds of shapes by their codes. Codes from 8 to 17 are curves and surfaces.
struct WkbKind {
  enum Code : std::uint32_t {
    kPoint = 1,
    kLineString,
    kPolygon,
    kMultiPoint,
    kMultiLineString,
    kMultiPolygon,
    kCollection,
  };
};
constexpr std::array<const char*, 18> kNames = {"",
                                                "POINT",
                                                "LINESTRING",
                                                "POLYGON",
                                                "MULTIPOINT",
                                                "MULTILINESTRING",
                                                "MULTIPOLYGON",
                                                "GEOMETRYCOLLECTION",
                                                "CIRCULARSTRING",
                                                "COMPOUNDCURVE",
                                                "CURVEPOLYGON",
                                                "MULTICURVE",
                                                "MULTISURFACE",
                                                "CURVE",
                                                "SURFACE",
                                                "POLYHEDRALSURFACE",
                                                "TIN",
                                                "TRIANGLE"};

constexpr std::size_t kHeader = 5;  // the byte order and the code

/// What a code says: ISO adds 1000, 2000 or 3000 for Z, M and ZM, and PostGIS sets bits.
struct Code {
  static constexpr std::uint32_t kHasZ = 0x8000'0000;
  static constexpr std::uint32_t kHasM = 0x4000'0000;
  static constexpr std::uint32_t kHasSrid = 0x2000'0000;

  explicit Code(std::uint32_t code) : has_srid((code & kHasSrid) != 0) {
    const std::uint32_t plain = code & ~(kHasZ | kHasM | kHasSrid);
    const std::uint32_t dimensions = plain / 1000;
    if (dimensions > 3 || plain % 1000 >= kNames.size()) return;
    kind = plain % 1000;
    has_z = (code & kHasZ) != 0 || dimensions % 2 == 1;
    has_m = (code & kHasM) != 0 || dimensions >= 2;
  }

  std::uint32_t kind = 0;  ///< 0 if the code is not known
  bool has_z = false;
  bool has_m = false;
  bool has_srid;
};

template <class Value>
Value load(std::string_view bytes, bool little) {
  std::array<char, sizeof(Value)> raw;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    raw[i] = bytes[little == (std::endian::native == std::endian::little) ? i : raw.size() - 1 - i];
  }
  return std::bit_cast<Value>(raw);
}

class WkbReader {
 public:
  WkbReader(std::string_view bytes, const ReadOptions& options, GeometryBuilder& builder)
      : cursor_(bytes, TextCursor::Counts::kBytes), options_(options), builder_(builder) {
    builder_.follow(cursor_);
  }

  void read() {
    geometry(0);
    if (!cursor_.at_end()) {
      cursor_.fail("expected the end, found " + std::to_string(cursor_.rest().size()) +
                   " more bytes");
    }
  }

 private:
  /// Reads a shape; `member` is the kind that it must have, or 0 for any.
  void geometry(std::uint32_t member) {
    const std::size_t start = cursor_.position();
    const auto order = static_cast<unsigned char>(take<char>("the byte order"));
    if (order > 1) {
      cursor_.fail(ErrorCode::kBadInput,
                   "expected the byte order, 0 or 1, found " + std::to_string(order), start);
    }
    little_ = order == 1;
    const std::size_t place = cursor_.position();
    const auto number = take<std::uint32_t>("the code of the geometry");
    const Code code(number);
    const auto fail_here = [&](const std::string& message) {
      cursor_.fail(ErrorCode::kBadInput, message, place);
    };
    if (code.kind == 0) fail_here("code " + std::to_string(number) + " names no geometry");
    const std::string name = kNames[code.kind];
    if (member != 0 && code.kind != member) {
      fail_here("expected a " + std::string(kNames[member]) + ", found a " + name);
    }
    if ((code.has_z || code.has_m) && !options_.drop_z) {
      fail_here(name + ' ' + (code.has_z ? "Z" : "") + (code.has_m ? "M" : "") + more_than_two());
    }
    if (code.kind > WkbKind::kCollection) fail_here(name + " is not supported");
    if (builder_.rules() == Rules::kRegion && code.kind != WkbKind::kPolygon &&
        code.kind != WkbKind::kMultiPolygon && code.kind != WkbKind::kCollection) {
      fail_here("a region needs polygons: " + name + " has no area");
    }
    if (code.has_srid) {
      const std::size_t srid_place = cursor_.position();
      const auto srid = static_cast<std::int32_t>(take<std::uint32_t>("the reference system"));
      builder_.set_srid(std::max(srid, 0), srid_place);
    }
    dropped_ = (std::size_t{code.has_z} + std::size_t{code.has_m}) * sizeof(double);
    content(code.kind);
  }

  void content(std::uint32_t kind) {
    switch (kind) {
      case WkbKind::kPoint:
        return point();
      case WkbKind::kLineString:
        return line();
      case WkbKind::kPolygon:
        return polygon();
      default:
        break;
    }
    if (depth_ >= options_.max_depth) {
      cursor_.fail(
          ErrorCode::kLimitExceeded,
          "collections are nested deeper than the limit of " + std::to_string(options_.max_depth),
          cursor_.position(),
          ExceededLimit{"io::ReadOptions::max_depth",
                        static_cast<std::uint64_t>(options_.max_depth)});
    }
    ++depth_;
    const std::uint32_t member =
        kind == WkbKind::kCollection ? 0 : kind - WkbKind::kMultiPoint + WkbKind::kPoint;
    const bool little = little_;  // each member has its own
    for (auto left = take_count("geometries", kHeader); left > 0; --left) geometry(member);
    little_ = little;
    --depth_;
  }

  // The empty point has no numbers as coordinates.
  void point() {
    const std::size_t start = cursor_.position();
    const auto [x, y] = doubles();
    if (std::isnan(x) && std::isnan(y)) return;
    builder_.add_point(number(x, start), number(y, start + sizeof(double)));
  }

  void line() {
    builder_.begin_line();
    for (auto left = take_count("points", 2 * sizeof(double) + dropped_); left > 0; --left) {
      const auto [x, y] = position();
      builder_.add_to_line(x, y);
    }
    builder_.end_line();
  }

  void polygon() {
    auto left = take_count("rings", sizeof(std::uint32_t));
    if (left > 0) builder_.begin_polygon();
    for (; left > 0; --left) {
      builder_.begin_closed_ring();
      for (auto points = take_count("points", 2 * sizeof(double) + dropped_); points > 0;
           --points) {
        auto [x, y] = position();
        builder_.add_to_closed_ring(std::move(x), std::move(y));
      }
      builder_.end_closed_ring();
    }
  }

  std::pair<Number, Number> position() {
    const std::size_t start = cursor_.position();
    const auto [x, y] = doubles();
    return {number(x, start), number(y, start + sizeof(double))};
  }

  std::pair<double, double> doubles() {
    const auto x = take<double>("a coordinate");
    const auto y = take<double>("a coordinate");
    if (cursor_.rest().size() < dropped_)
      cursor_.fail("expected a height or measure, found the end");
    cursor_.advance(dropped_);
    return {x, y};
  }

  Number number(double value, std::size_t place) const {
    if (!std::isfinite(value)) {
      cursor_.fail(ErrorCode::kBadInput, "a coordinate is not a finite number", place);
    }
    constexpr double kShort = 1e15;  // integers below this are doubles and short decimals
    Number number;
    number.is_decimal = std::abs(value) < kShort && value == std::trunc(value);
    if (number.is_decimal) {
      number.decimal.mantissa = static_cast<std::int64_t>(value);
    } else {
      number.rational = value;
    }
    return number;
  }

  // Counts are compared with the bytes that are left, so a false one costs nothing.
  std::uint32_t take_count(const std::string& what, std::size_t bytes_each) {
    const std::size_t start = cursor_.position();
    const auto count = take<std::uint32_t>("the number of " + what);
    if (count > cursor_.rest().size() / bytes_each) {
      cursor_.fail(ErrorCode::kBadInput,
                   std::to_string(count) + ' ' + what + " do not fit into the " +
                       std::to_string(cursor_.rest().size()) + " bytes that are left",
                   start);
    }
    return count;
  }

  template <class Value>
  Value take(const std::string& what) {
    if (cursor_.rest().size() < sizeof(Value)) {
      cursor_.fail("expected " + what + ", found the end after " +
                   std::to_string(cursor_.rest().size()) + " of " + std::to_string(sizeof(Value)) +
                   " bytes");
    }
    const auto value = load<Value>(cursor_.rest(), little_);
    cursor_.advance(sizeof(Value));
    return value;
  }

  TextCursor cursor_;
  const ReadOptions& options_;
  GeometryBuilder& builder_;
  std::size_t dropped_ = 0;  ///< bytes of each point behind x and y
  bool little_ = true;
  int depth_ = 0;
};

class WkbWriter {
 public:
  WkbWriter(const Sink& out, const Coordinates& style)
      : out_(out),
        options_{.cancel = style.cancel},
        cancellation_(options_),
        srid_(srid_of(style)) {}

  void write(const GeometryView& geometry) {
    const Region& region = geometry.region;
    if (geometry.kinds() > 1) {
      begin(WkbKind::kCollection);
      put(static_cast<std::uint32_t>(geometry.kinds()));
    }
    if (!region.empty() || geometry.kinds() == 0) {
      const IndexRange polygons = region.empty() ? IndexRange(0, 0) : region.polygons();
      kind(WkbKind::kPolygon, polygons, [&](std::size_t polygon) {
        const IndexRange rings = region.rings_of(polygon);
        put_count(rings.size());
        for (const std::size_t r : rings) ring(region, region.vertices_of(r));
      });
    }
    kind_if_any(WkbKind::kLineString, geometry.polylines, [&](const Polyline& line) {
      put_count(line.size());
      for (const Point& at : line) point(at);
    });
    kind_if_any(WkbKind::kPoint, geometry.points, [&](const Point& at) { point(at); });
    flush();
  }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 16;

  template <class Items, class Write>
  void kind_if_any(WkbKind::Code one, const Items& items, Write write) {
    if (!items.empty()) kind(one, items, write);
  }
  /// Writes a single item of a kind as such, and several as a collection of that kind.
  template <class Items, class Write>
  void kind(WkbKind::Code one, const Items& items, Write write) {
    if (items.empty()) {
      begin(one);
      return put_count(0);
    }
    if (items.size() > 1) {
      begin(static_cast<WkbKind::Code>(one - WkbKind::kPoint + WkbKind::kMultiPoint));
      put_count(items.size());
    }
    for (const auto& item : items) {
      begin(one);
      write(item);
    }
  }
  void ring(const Region& region, IndexRange vertices) {
    put_count(vertices.empty() ? 0 : vertices.size() + 1);
    for (const std::size_t v : vertices) vertex(region, v);
    if (!vertices.empty()) vertex(region, vertices.front());
  }
  void vertex(const Region& region, std::size_t v) {
    cancellation_.check(8);
    coordinate(region.x(v));
    coordinate(region.y(v));
  }
  void point(const Point& at) {
    cancellation_.check(work_of_product(at.x.bits() + at.y.bits()));
    coordinate(at.x.to_double());
    coordinate(at.y.to_double());
  }
  void coordinate(double value) {
    check_finite(value);
    put(std::bit_cast<std::uint64_t>(value));
  }
  void begin(WkbKind::Code kind) {
    buffer_ += '\1';                             // little-endian
    const auto srid = std::exchange(srid_, {});  // which only the first header has
    put(static_cast<std::uint32_t>(kind) | (srid ? Code::kHasSrid : 0U));
    if (srid) put(static_cast<std::uint32_t>(*srid));
  }
  void put_count(std::size_t count) {
    if (count > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorCode::kLimitExceeded, "WKB counts no more than 2^32 - 1 items", {}, {},
                  ExceededLimit{"WKB", std::numeric_limits<std::uint32_t>::max()});
    }
    put(static_cast<std::uint32_t>(count));
  }
  template <class Value>
  void put(Value value) {
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
      buffer_ += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
    }
    if (buffer_.size() >= kChunk) flush();
  }
  void flush() {
    out_(buffer_);
    buffer_.clear();
  }

  const Sink& out_;
  Options options_;  ///< of writing
  Cancellation cancellation_;
  std::optional<std::int32_t> srid_;
  std::string buffer_;
};

}  // namespace

bool looks_like_wkb(std::string_view bytes) {
  if (bytes.size() < kHeader || static_cast<unsigned char>(bytes[0]) > 1) return false;
  return Code(load<std::uint32_t>(bytes.substr(1), bytes[0] == 1)).kind != 0;
}

void read_wkb(std::string_view bytes, const ReadOptions& options, GeometryBuilder& builder) {
  WkbReader(bytes, options, builder).read();
}

void write_wkb(const Sink& out, const GeometryView& geometry, const Coordinates& style) {
  if (style.style != Coordinates::Style::kDouble) {
    refuse_input("WKB holds doubles, not exact numbers or decimals");
  }
  WkbWriter(out, style).write(geometry);
}

}  // namespace minksum::io

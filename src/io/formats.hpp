// Declares a reader and a writer for each format.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/geometry_builder.hpp"
#include "minksum/io.hpp"

namespace minksum::io {

/// The words that begin a text in WKT, in capitals.
inline constexpr std::array<std::string_view, 8> kWktTypes = {
    "POINT",        "LINESTRING",         "POLYGON",   "MULTIPOINT", "MULTILINESTRING",
    "MULTIPOLYGON", "GEOMETRYCOLLECTION", "LINEARRING"};

// Readers of a whole text, which is one feature.
void read_poly(std::string_view text, const ReadOptions& options, GeometryBuilder& builder);
void read_dat(std::string_view text, const ReadOptions& options, GeometryBuilder& builder);
void read_svg(std::string_view text, const ReadOptions& options, GeometryBuilder& builder);
void read_dxf(std::string_view text, const ReadOptions& options, GeometryBuilder& builder);
void read_wkb(std::string_view bytes, const ReadOptions& options, GeometryBuilder& builder);

// Readers of one geometry at the cursor. Something else may follow it.
void read_wkt(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder);
/// Reads WKB whose bytes are written as hexadecimal digits.
void read_hex_wkb(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder);
/// Reads either of the two, which its first characters tell.
void read_wkt_or_hex_wkb(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder);

/// Returns the text without a mark of UTF-8 at its beginning.
[[nodiscard]] std::string_view without_mark(std::string_view text);

/// Tells whether the text is XML whose first element is `svg`.
[[nodiscard]] bool looks_like_svg(std::string_view text);
/// Tells whether the text begins as a DXF drawing in ASCII.
[[nodiscard]] bool looks_like_dxf(std::string_view text);

/// Tells whether the first line names the columns of a table.
[[nodiscard]] bool looks_like_table(std::string_view text);
/// Throws a ReadError if the first line is a row of a table, and no geometry or list of some.
void refuse_rows_without_names(std::string_view text);

/// A format whose files are not read, or by GDAL alone.
struct OtherFormat {
  std::string name;
  std::string advice;  ///< what to do, unless GDAL opens it
  bool by_gdal = false;
};
/// Returns the format if the text begins as files of such a format. The text may be just the
/// beginning of one.
[[nodiscard]] std::optional<OtherFormat> find_other_format(std::string_view text);
/// Returns why JSON is not read that is of this type, or that has no type and a member of this
/// name; "" if that is not known.
[[nodiscard]] std::string refusal_of_json(std::string_view word);
/// Throws a ReadError that names the format.
[[noreturn]] void refuse(const OtherFormat& format, bool is_file);

/// Tells whether the bytes begin with a byte order and the code of a geometry.
[[nodiscard]] bool looks_like_wkb(std::string_view bytes);
/// Tells whether a text begins so in hexadecimal digits. That takes 18 of them, so a short number
/// is not taken for WKB.
[[nodiscard]] bool looks_like_hex_wkb(std::string_view text);

/// Refers to a geometry without owning it, so that regions are written without a copy.
struct GeometryView {
  const Region& region;
  std::span<const Polyline> polylines = {};
  std::span<const Point> points = {};
  /// Returns how many kinds are present: polygons, polylines, points.
  [[nodiscard]] int kinds() const {
    return int{!region.empty()} + int{!polylines.empty()} + int{!points.empty()};
  }
};

/// Returns the number that EWKT and EWKB have for it.
[[nodiscard]] std::optional<std::int32_t> srid_of(const Coordinates& style);

/// Takes what a writer has made, part by part. It may be a stream: code that writes into strings
/// alone must not need all of the C++ library's streams and locales, which would be a tenth of the
/// module in WebAssembly.
using Sink = std::function<void(std::string_view)>;

void write_wkt(const Sink& out, const GeometryView& geometry, const Coordinates& style);
void write_geojson(const Sink& out, const GeometryView& geometry, const Coordinates& style);
void write_poly(const Sink& out, const Region& region, const Coordinates& style);
void write_wkb(const Sink& out, const GeometryView& geometry, const Coordinates& style);
/// Writes WKB as hexadecimal digits.
void write_hex_wkb(const Sink& out, const GeometryView& geometry, const Coordinates& style);
void write_svg(const Sink& out, const GeometryView& geometry);

}  // namespace minksum::io

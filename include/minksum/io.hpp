// Declares reading and writing of regions and geometries as text. The CMake target is minksum::io.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "minksum/cancel.hpp"
#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/region.hpp"

namespace minksum::io {

/// Names a format. docs/formats.md describes all of them.
enum class Format {
  kWkt,      ///< Well-Known Text of the Open Geospatial Consortium
  kGeoJson,  ///< RFC 7946
  kPoly,     ///< `.poly`: chains of points, and which of them are holes
  kDat,      ///< `.dat`: CGAL's plain polygons, which are only read
  kSvg,      ///< a picture, which is only written
  kWkb,  ///< Well-Known Binary; when read, also PostGIS's form, and either in hexadecimal digits
};

/// An error in a text, with its place. Lines and columns count from 1; 0 means not known.
class MINKSUM_API ReadError : public Error {
 public:
  /// Makes an Error that has a line and a column.
  ReadError(ErrorCode code, const std::string& message, std::size_t line, std::size_t column,
            const std::optional<ExceededLimit>& limit = {})
      : Error(code, message, {}, {}, limit), line_(line), column_(column) {}
  /// Returns the line of the text, from 1.
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// Returns the column in that line, from 1.
  [[nodiscard]] std::size_t column() const noexcept { return column_; }

 private:
  std::size_t line_;
  std::size_t column_;
};

/// Limits on what is read. Exceeding one is a ReadError(kLimitExceeded) that names it. A token that
/// is cancelled leads to Error(kCancelled).
struct ReadLimits {
  std::size_t max_bytes = std::size_t{1} << 30;     ///< size of the text
  std::size_t max_vertices = std::size_t{1} << 30;  ///< vertices of rings and polylines, and points
  int max_depth = 32;                               ///< depth of parentheses, brackets and braces
  std::optional<CancelToken> cancel = {};           ///< stops reading
};

/// Returns the format in which the text seems to be, by its first characters, or else WKT.
[[nodiscard]] MINKSUM_API Format detect_format(std::string_view text);

/// Returns the areas, polylines and points of a text. The text is WKT, GeoJSON, WKB, `.poly` or
/// `.dat`, which its content tells.
///
/// Numbers are read exactly. Only the form of the text is checked. Rings may cross themselves and
/// each other, and may have one vertex or two; `resolve` tells what they mean. In `.dat`, rings of
/// fewer than three vertices are expected only if the text makes no sense without them. O(n) for n
/// characters. Throws ReadError: kBadInput with line and column, or with the number of the byte in
/// the message if the text is WKB; kLimitExceeded. Throws Error(kCancelled).
[[nodiscard]] MINKSUM_API Geometry read_geometry(std::string_view text,
                                                 const ReadLimits& limits = {});
/// Returns the same from a file, or from standard input for "-". A file that cannot be read is a
/// ReadError(kBadInput) without a line. Messages do not name the file, which the caller knows.
[[nodiscard]] MINKSUM_API Geometry read_geometry_file(const std::string& path,
                                                      const ReadLimits& limits = {});

/// Returns the region of a text, which is read as above. Polylines, points and rings of fewer than
/// three vertices are errors.
[[nodiscard]] MINKSUM_API Region read(std::string_view text, const ReadLimits& limits = {});
/// Returns the region of a file, or of standard input for "-". Throws as above.
[[nodiscard]] MINKSUM_API Region read_file(const std::string& path, const ReadLimits& limits = {});

/// Returns the text of a file, or of standard input for "-". Throws as read_geometry_file does.
[[nodiscard]] MINKSUM_API std::string load_text(const std::string& path,
                                                const ReadLimits& limits = {});
/// Returns the `properties` of a text that is one GeoJSON Feature, or a FeatureCollection of one,
/// as they are written there ("null" if it has none). Returns nothing for any other text. Throws as
/// read_geometry does.
[[nodiscard]] MINKSUM_API std::optional<std::string> feature_properties(
    std::string_view text, const ReadLimits& limits = {});

/// Says how coordinates are written.
struct Coordinates {
  /// Says as which numbers coordinates are written.
  enum class Style {
    kDouble,   ///< the nearest doubles, in the fewest digits that are read as these doubles
    kExact,    ///< integers and fractions such as "1/3"; GeoJSON has finite decimals where it can
    kDecimal,  ///< decimals with `digits` digits after the point
  };
  Style style = Style::kDouble;  ///< the kind of numbers
  int digits = 6;                ///< digits after the point for kDecimal, 0 to kMaxDecimals
  /// Stops writing by Error(kCancelled). What was written before stays.
  std::optional<CancelToken> cancel = {};
};

/// Writes a region as WKT, GeoJSON, WKB, `.poly` or a plain SVG. WKB is little-endian and holds
/// doubles. O(n) for n vertices. Throws Error: kBadInput for `.dat`, which is only read, for WKB in
/// another style than kDouble, and for a number of digits that is out of range; kLimitExceeded for
/// a coordinate beyond the range of doubles that has to be written as one; kCancelled.
MINKSUM_API void write(std::ostream& out, const Region& region, Format format,
                       const Coordinates& style = {});
/// Returns the region as WKT. This and all functions below throw as `write` does.
[[nodiscard]] MINKSUM_API std::string to_wkt(const Region& region, const Coordinates& style = {});
/// Writes a geometry. Several kinds of parts become a collection. A geometry that is written with
/// exact coordinates and read again is equal. `.poly` has no form for thin parts: Error(kBadInput).
MINKSUM_API void write(std::ostream& out, const Geometry& geometry, Format format,
                       const Coordinates& style = {});
/// Returns the geometry as WKT.
[[nodiscard]] MINKSUM_API std::string to_wkt(const Geometry& geometry,
                                             const Coordinates& style = {});
/// Returns the region as a GeoJSON geometry object. With exact coordinates, numbers that are not
/// finite decimals are strings ("1/3").
[[nodiscard]] MINKSUM_API std::string to_geojson(const Region& region,
                                                 const Coordinates& style = {});
/// Returns the same for a geometry with thin parts.
[[nodiscard]] MINKSUM_API std::string to_geojson(const Geometry& geometry,
                                                 const Coordinates& style = {});
/// Returns the region as WKB: bytes, not digits.
[[nodiscard]] MINKSUM_API std::string to_wkb(const Region& region, const Coordinates& style = {});
/// Returns the same for a geometry with thin parts.
[[nodiscard]] MINKSUM_API std::string to_wkb(const Geometry& geometry,
                                             const Coordinates& style = {});

}  // namespace minksum::io

namespace minksum {

/// Writes WKT with the nearest doubles. Throws as io::write does.
MINKSUM_API std::ostream& operator<<(std::ostream& out, const Region& region);
/// Writes the same for a geometry with thin parts.
MINKSUM_API std::ostream& operator<<(std::ostream& out, const Geometry& geometry);

}  // namespace minksum

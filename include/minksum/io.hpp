// Reading and writing regions and geometries as text. Target minksum::io.
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

/// The text formats; docs/formats.md describes them.
enum class Format {
  kWkt,      ///< Well-Known Text of the Open Geospatial Consortium
  kGeoJson,  ///< RFC 7946
  kPoly,     ///< `.poly`: chains of points, and which are holes
  kDat,      ///< `.dat`: CGAL's plain polygons; is only read
  kSvg,      ///< a picture; is only written
};

/// A fault in a text, with its place. Lines and columns count from 1; 0 = not known.
class MINKSUM_API ReadError : public Error {
 public:
  /// As Error, with a line and a column.
  ReadError(ErrorCode code, const std::string& message, std::size_t line, std::size_t column,
            const std::optional<ExceededLimit>& limit = {})
      : Error(code, message, {}, {}, limit), line_(line), column_(column) {}
  /// The line of the text; from 1.
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// The column in that line; from 1.
  [[nodiscard]] std::size_t column() const noexcept { return column_; }

 private:
  std::size_t line_;
  std::size_t column_;
};

/// Limits on what is read; exceeding one is a ReadError(kLimitExceeded) that names it. A token that
/// is cancelled makes an Error(kCancelled).
struct ReadLimits {
  std::size_t max_bytes = std::size_t{1} << 30;     ///< of the text
  std::size_t max_vertices = std::size_t{1} << 30;  ///< of rings and polylines, and points
  int max_depth = 32;                               ///< nesting of parentheses, brackets and braces
  std::optional<CancelToken> cancel = {};           ///< stops reading
};

/// The format that the text seems to be in, by its first characters; WKT if it says nothing.
[[nodiscard]] MINKSUM_API Format detect_format(std::string_view text);

/// Reads areas, polylines and points: WKT, GeoJSON, `.poly` or `.dat`, told by content.
///
/// Numbers are read exactly. Only the form of the text is checked: rings may cross themselves and
/// each other, and may have one vertex or two; `resolve` says what they mean. In `.dat`, rings of
/// fewer than three vertices are looked for only if the text makes no sense without them.
[[nodiscard]] MINKSUM_API Geometry read_geometry(std::string_view text,
                                                 const ReadLimits& limits = {});
/// Reads a file, or standard input for "-". Messages do not name the file: the caller knows it.
[[nodiscard]] MINKSUM_API Geometry read_geometry_file(const std::string& path,
                                                      const ReadLimits& limits = {});

/// Reads a region: as above, but polylines and points, and rings of fewer than three vertices, are
/// errors.
[[nodiscard]] MINKSUM_API Region read(std::string_view text, const ReadLimits& limits = {});
/// Reads a region from a file, or from standard input for "-".
[[nodiscard]] MINKSUM_API Region read_file(const std::string& path, const ReadLimits& limits = {});

/// The text of a file, or of standard input for "-".
[[nodiscard]] MINKSUM_API std::string load_text(const std::string& path,
                                                const ReadLimits& limits = {});
/// The `properties` of a text that is one GeoJSON Feature or a FeatureCollection of one, as they
/// are written there ("null" if it has none); nothing if it is anything else. Throws ReadError.
[[nodiscard]] MINKSUM_API std::optional<std::string> feature_properties(
    std::string_view text, const ReadLimits& limits = {});

/// How coordinates are written.
struct Coordinates {
  /// As which numbers they are written.
  enum class Style {
    kDouble,   ///< the nearest doubles, in the fewest digits that are read as these doubles
    kExact,    ///< integers and fractions, "1/3"; in GeoJSON finite decimals where they are
    kDecimal,  ///< decimals with `digits` digits after the point
  };
  Style style = Style::kDouble;  ///< as which numbers
  int digits = 6;                ///< for kDecimal: digits after the point, 0 to kMaxDecimals
  /// Cancels writing: Error(kCancelled). What was written until then stays.
  std::optional<CancelToken> cancel = {};
};

/// Writes WKT, GeoJSON, `.poly` or a plain SVG of the region. Throws Error: kBadInput for `.dat`,
/// which is only read, and for a number of digits that is out of range; kLimitExceeded for a
/// coordinate beyond the doubles that is to be written as one.
MINKSUM_API void write(std::ostream& out, const Region& region, Format format,
                       const Coordinates& style = {});
/// The region as WKT.
[[nodiscard]] MINKSUM_API std::string to_wkt(const Region& region, const Coordinates& style = {});
/// The same with thin parts: a collection if there are several kinds of parts. What is written with
/// exact coordinates and read again is equal. `.poly` has no form for thin parts: Error(kBadInput).
MINKSUM_API void write(std::ostream& out, const Geometry& geometry, Format format,
                       const Coordinates& style = {});
/// The geometry as WKT.
[[nodiscard]] MINKSUM_API std::string to_wkt(const Geometry& geometry,
                                             const Coordinates& style = {});
/// A GeoJSON geometry object. Numbers that are no finite decimals are strings ("1/3").
[[nodiscard]] MINKSUM_API std::string to_geojson(const Region& region,
                                                 const Coordinates& style = {});
/// The same with thin parts.
[[nodiscard]] MINKSUM_API std::string to_geojson(const Geometry& geometry,
                                                 const Coordinates& style = {});

}  // namespace minksum::io

namespace minksum {

/// WKT with the nearest doubles. Throws as io::write does.
MINKSUM_API std::ostream& operator<<(std::ostream& out, const Region& region);
/// The same with thin parts.
MINKSUM_API std::ostream& operator<<(std::ostream& out, const Geometry& geometry);

}  // namespace minksum

// Declares reading and writing of regions and geometries as text. The CMake target is minksum::io.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "minksum/cancel.hpp"
#include "minksum/export.h"
#include "minksum/geometry.hpp"
#include "minksum/region.hpp"
#include "minksum/round.hpp"

namespace minksum::io {

/// Names a format. docs/formats.md describes all of them.
enum class Format {
  kWkt,      ///< Well-Known Text of the Open Geospatial Consortium
  kGeoJson,  ///< RFC 7946
  kPoly,     ///< `.poly`: chains of points, and which of them are holes
  kDat,      ///< `.dat`: CGAL's plain polygons, which are only read
  kSvg,      ///< Scalable Vector Graphics: drawings when read, pictures when written
  kWkb,     ///< Well-Known Binary; when read, also PostGIS's form, and either in hexadecimal digits
  kDxf,     ///< Drawing Exchange Format of AutoCAD, which is only read
  kHexWkb,  ///< WKB in hexadecimal digits, which is only written: kWkb reads both
  kTable,   ///< CSV and TSV with a column of WKT or hexadecimal WKB, which are only read
  kGdal,    ///< what load_text makes of a file that GDAL opens, which is only read
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

/// Says how drawings are read (SVG and DXF).
struct DrawingOptions {
  /// How far the polyline of a curve may be off, in the unit of the result. A drawing with curves
  /// is an error without it. So is one with shapes that are turned by angles whose sines are
  /// irrational. Must be positive.
  std::optional<Rational> tolerance = {};
  /// kOutside: areas contain those of the drawing. kInside: they are contained. kNearest: they have
  /// fewer vertices.
  RoundingSide side = RoundingSide::kNearest;
  /// Reads this layer alone; "" = all that are shown. A file that GDAL opens needs it if there are
  /// several.
  std::string layer = {};
  /// Joins ends of outlines that are at most so far apart by straight pieces. Without it, only
  /// equal ends are joined. DXF draws an outline in pieces. Must not be negative.
  Rational join_ends = {};
};

/// Says how a text is read, and within which limits. Exceeding a limit is a
/// ReadError(kLimitExceeded) that names it. A token that is cancelled leads to Error(kCancelled).
struct ReadOptions {
  std::size_t max_bytes = std::size_t{1} << 30;     ///< size of the text
  std::size_t max_vertices = std::size_t{1} << 30;  ///< vertices of rings and polylines, and points
  int max_depth = 32;                               ///< depth of parentheses, brackets and braces
  std::optional<CancelToken> cancel = {};           ///< stops reading
  /// Drops what a point has beyond x and y: heights (Z) and measures (M). Otherwise they are
  /// errors.
  bool drop_z = false;
  /// Names the column of a table (CSV, TSV) that holds the geometries. Without a name it is found.
  std::string column = {};
  DrawingOptions drawing = {};  ///< how drawings are read
};

/// What a text says once about all that it holds, and how much of it has no shape.
struct SourceInfo {
  /// The number of the reference system (EWKT, EWKB); 0, which means unknown, counts as nothing.
  std::optional<std::int32_t> srid = {};
  /// The member `crs` of GeoJSON, as it is written, or one that names a system of another authority
  /// than EPSG in a file that GDAL opens; or "".
  std::string crs = {};
  std::size_t features = 0;          ///< features, including those without a shape
  std::size_t null_geometries = 0;   ///< features whose geometry is `null`, or an empty cell
  std::size_t empty_geometries = 0;  ///< features whose geometry is empty
  std::string unit = {};  ///< what the coordinates of a drawing count, such as "mm"; or ""
  /// What a result cannot show, such as "not read: 2 TEXT, 1 HATCH" of a drawing; or "".
  std::string remarks = {};
};

/// All that a text holds, as one set.
struct Document {
  Geometry geometry;  ///< all features together
  SourceInfo source;  ///< what holds for all of them
  /// The `properties` of the only feature, see Feature. Nothing if there are more, or it has none.
  std::optional<std::string> properties = {};
};

/// One feature of a text: one record with its geometry.
struct Feature {
  Geometry geometry;  ///< never empty
  /// In GeoJSON the member `properties` as it is written ("null" if it is missing), and for a bare
  /// geometry "". In a table a JSON object of the other cells, as strings.
  std::string properties = {};
  std::string id = {};    ///< the member `id` as it is written, in quotes if it is a string; or ""
  std::size_t index = 0;  ///< counts from 0, with the features that have no shape
  std::size_t line = 0;   ///< where the feature begins, from 1; 0 in binary formats
};

/// Returns the number of the reference system that a text names by `srid`, or else by a `crs` such
/// as `urn:ogc:def:crs:EPSG::3857`. The `crs` of GeoJSON itself, CRS84, has the number 4326.
[[nodiscard]] MINKSUM_API std::optional<std::int32_t> srid_of(const SourceInfo& source);

/// Returns the format in which the text seems to be, by its first characters, or else WKT.
[[nodiscard]] MINKSUM_API Format detect_format(std::string_view text);

/// Returns the areas, polylines and points of a text. Its content tells the format.
///
/// Numbers are read exactly. Only the form of the text is checked. Rings may cross themselves and
/// each other, and may have one vertex or two; `resolve` tells what they mean. In `.dat`, rings of
/// fewer than three vertices are expected only if the text makes no sense without them. O(n) for n
/// characters. Throws ReadError: kBadInput with line and column, or with the number of the byte in
/// the message if the text is WKB; kLimitExceeded. Throws Error(kCancelled).
[[nodiscard]] MINKSUM_API Geometry read_geometry(std::string_view text,
                                                 const ReadOptions& options = {});
/// Returns the same from a file, or from standard input for "-". A file that cannot be read is a
/// ReadError(kBadInput) without a line. Messages do not name the file, which the caller knows.
[[nodiscard]] MINKSUM_API Geometry read_geometry_file(const std::string& path,
                                                      const ReadOptions& options = {});

/// Returns the region of a text, which is read as above. Polylines, points and rings of fewer than
/// three vertices are errors.
[[nodiscard]] MINKSUM_API Region read(std::string_view text, const ReadOptions& options = {});
/// Returns the region of a file, or of standard input for "-". Throws as above.
[[nodiscard]] MINKSUM_API Region read_file(const std::string& path,
                                           const ReadOptions& options = {});

/// Returns the text of a file, or of standard input for "-". Where GDAL is installed, a file or
/// folder in a format that minksum does not read, such as a Shapefile, becomes a text of its
/// features. Throws as read_geometry_file does.
[[nodiscard]] MINKSUM_API std::string load_text(const std::string& path,
                                                const ReadOptions& options = {});
/// Returns what read_geometry does, with what the text says about it. Throws as that does.
[[nodiscard]] MINKSUM_API Document read_document(std::string_view text,
                                                 const ReadOptions& options = {});
/// Returns the same from a file, or from standard input for "-".
[[nodiscard]] MINKSUM_API Document read_document_file(const std::string& path,
                                                      const ReadOptions& options = {});

/// Gives the features of a text one after another, so that only one is in memory beside the text.
///
/// A feature is a Feature of GeoJSON, a geometry of WKT or hexadecimal WKB, or a row of a table.
/// Any other text is one feature. Features without a shape are passed over and counted.
class MINKSUM_API FeatureReader {
 public:
  /// Reads a text, which must live as long. Throws as read_geometry does, for what the first
  /// characters tell.
  explicit FeatureReader(std::string_view text, const ReadOptions& options = {});
  /// Refuses a string that ends with the expression: give it a name first.
  template <std::same_as<std::string> Text>
  explicit FeatureReader(Text&& text, const ReadOptions& options = {}) = delete;
  /// Reads a file, or standard input for "-". Throws as read_geometry_file does.
  [[nodiscard]] static FeatureReader from_file(const std::string& path,
                                               const ReadOptions& options = {});
  ~FeatureReader();
  /// Takes over what the other one reads, which may then only be assigned to or destroyed.
  FeatureReader(FeatureReader&& other) noexcept;
  /// Takes over what the other one reads, and gives up what this one read.
  FeatureReader& operator=(FeatureReader&& other) noexcept;

  /// Returns the next feature, or nothing at the end and after an error. Throws as read_geometry
  /// does. The limit on vertices holds for each feature.
  [[nodiscard]] std::optional<Feature> next();
  /// Returns what the text has said so far. All of it is known when next() has returned nothing.
  [[nodiscard]] const SourceInfo& source() const;
  /// Returns which share of the text lies before the latest feature, from 0 to 1.
  [[nodiscard]] double share() const;

 private:
  struct State;
  explicit FeatureReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

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
  /// The number of the reference system. WKT and WKB have it as EWKT and EWKB, and GeoJSON has it
  /// as its member `crs`. Other formats have no place for it.
  std::optional<std::int32_t> srid = {};
  /// The member `crs` of GeoJSON, instead of one that is made of `srid`; or "".
  std::string crs = {};
};

/// Returns the member `crs` that GeoJSON has for the reference system; "" if there is none.
[[nodiscard]] MINKSUM_API std::string crs_of(const Coordinates& style);

/// Writes a region as WKT, GeoJSON, WKB, `.poly` or a plain SVG. WKB is little-endian and holds
/// doubles; kHexWkb writes its bytes as digits. O(n) for n vertices. Throws Error: kBadInput for a
/// format that is only read, for WKB in another style than kDouble, and for a number of digits that
/// is out of range; kLimitExceeded for a coordinate beyond the range of doubles that has to be
/// written as one; kCancelled.
MINKSUM_API void write(std::ostream& out, const Region& region, Format format,
                       const Coordinates& style = {});
/// Returns the region as WKT. This and all functions below throw as `write` does.
[[nodiscard]] MINKSUM_API std::string to_wkt(const Region& region, const Coordinates& style = {});
/// Writes a geometry. Several kinds of parts become a collection. A geometry that is written with
/// exact coordinates and read again is equal. `.poly` has no form for thin parts: Error(kBadInput).
MINKSUM_API void write(std::ostream& out, const Geometry& geometry, Format format,
                       const Coordinates& style = {});
/// Returns what that writes as a string.
[[nodiscard]] MINKSUM_API std::string to_text(const Geometry& geometry, Format format,
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

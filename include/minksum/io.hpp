// Reading and writing regions as text. Target minksum::io.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

#include "minksum/geometry.hpp"
#include "minksum/region.hpp"

namespace minksum::io {

enum class Format { kWkt, kGeoJson, kPoly, kDat, kSvg };

/// A fault in a text, with its place. Lines and columns count from 1; 0 = not known.
class ReadError : public Error {
 public:
  ReadError(ErrorCode code, const std::string& message, std::size_t line, std::size_t column)
      : Error(code, message), line_(line), column_(column) {}
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  [[nodiscard]] std::size_t column() const noexcept { return column_; }

 private:
  std::size_t line_;
  std::size_t column_;
};

/// Limits on what is read; exceeding one is a ReadError(kLimitExceeded) that names it.
struct ReadLimits {
  std::size_t max_bytes = std::size_t{1} << 30;
  int max_depth = 32;  ///< nesting of parentheses, brackets and braces
};

/// The format that the text seems to be in, by its first characters; WKT if it says nothing.
[[nodiscard]] Format detect_format(std::string_view text);
/// Reads areas, polylines and points: WKT, GeoJSON, `.poly` or `.dat`, told by content.
[[nodiscard]] Geometry read_geometry(std::string_view text, const ReadLimits& limits = {});
/// Reads a file, or standard input for "-". Messages do not name the file: the caller knows it.
[[nodiscard]] Geometry read_geometry_file(const std::string& path, const ReadLimits& limits = {});
/// Reads a region: WKT, GeoJSON, `.poly` or `.dat`, told by content. Numbers are read exactly.
[[nodiscard]] Region read(std::string_view text, const ReadLimits& limits = {});
/// Reads a file, or standard input for "-". Messages do not name the file: the caller knows it.
[[nodiscard]] Region read_file(const std::string& path, const ReadLimits& limits = {});

/// How coordinates are written.
struct Coordinates {
  enum class Style { kDouble, kExact, kDecimal };
  Style style = Style::kDouble;
  int digits = 6;  ///< for kDecimal: digits after the point
};

/// Writes WKT, GeoJSON, `.poly` or a plain SVG of the region.
void write(std::ostream& out, const Region& region, Format format, const Coordinates& style = {});
[[nodiscard]] std::string to_wkt(const Region& region, const Coordinates& style = {});
/// The same with thin parts. `.poly` has no form for these: Error(kBadInput).
void write(std::ostream& out, const Geometry& geometry, Format format,
           const Coordinates& style = {});
[[nodiscard]] std::string to_wkt(const Geometry& geometry, const Coordinates& style = {});

}  // namespace minksum::io

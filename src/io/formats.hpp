// Declares a reader and a writer for each format.
#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "io/geometry_builder.hpp"
#include "minksum/io.hpp"

namespace minksum::io {

[[nodiscard]] Geometry read_wkt(std::string_view text, const ReadLimits& limits, Rules rules);
[[nodiscard]] Geometry read_geojson(std::string_view text, const ReadLimits& limits, Rules rules);
[[nodiscard]] Geometry read_poly(std::string_view text, const ReadLimits& limits, Rules rules);
[[nodiscard]] Geometry read_dat(std::string_view text, const ReadLimits& limits, Rules rules);
[[nodiscard]] Geometry read_wkb(std::string_view bytes, const ReadLimits& limits, Rules rules);
/// Reads WKB whose bytes are written as hexadecimal digits.
[[nodiscard]] Geometry read_hex_wkb(std::string_view text, const ReadLimits& limits, Rules rules);

/// Throws a ReadError that names the format, if the text begins as files of a format that is not
/// read.
void refuse_other_formats(std::string_view text);

/// Tells whether the bytes begin with a byte order and the code of a geometry.
[[nodiscard]] bool looks_like_wkb(std::string_view bytes);
/// Tells whether a text begins so in hexadecimal digits. That takes 18 of them, so a short number
/// is not taken for WKB.
[[nodiscard]] bool looks_like_hex_wkb(std::string_view text);

/// Returns the same as `feature_properties`, for a text that is GeoJSON.
[[nodiscard]] std::optional<std::string> geojson_properties(std::string_view text,
                                                            const ReadLimits& limits);

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

void write_wkt(std::ostream& out, const GeometryView& geometry, const Coordinates& style);
void write_geojson(std::ostream& out, const GeometryView& geometry, const Coordinates& style);
void write_poly(std::ostream& out, const Region& region, const Coordinates& style);
void write_wkb(std::ostream& out, const GeometryView& geometry, const Coordinates& style);
void write_svg(std::ostream& out, const GeometryView& geometry);

}  // namespace minksum::io

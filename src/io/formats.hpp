// One reader and one writer a format.
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

/// See `feature_properties`.
[[nodiscard]] std::optional<std::string> geojson_properties(std::string_view text,
                                                            const ReadLimits& limits);

/// A geometry that is not owned: so regions are written without being copied.
struct GeometryView {
  const Region& region;
  std::span<const Polyline> polylines = {};
  std::span<const Point> points = {};
  /// How many kinds there are: polygons, polylines, points.
  [[nodiscard]] int kinds() const {
    return int{!region.empty()} + int{!polylines.empty()} + int{!points.empty()};
  }
};

void write_wkt(std::ostream& out, const GeometryView& geometry, const Coordinates& style);
void write_geojson(std::ostream& out, const GeometryView& geometry, const Coordinates& style);
void write_poly(std::ostream& out, const Region& region, const Coordinates& style);
void write_svg(std::ostream& out, const GeometryView& geometry);

}  // namespace minksum::io

// Fuzzes readers. For any bytes, a reader must return an answer or throw a ReadError with a place.
// An answer that is written exactly and read again must be equal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/measure.hpp"

namespace minksum::io {

inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

// Returns whether a point can be read again. As a quotient, a number near the limits may need more
// digits than a reader takes.
inline bool can_come_back(const Point& point) {
  constexpr std::size_t kBits = 13'000;
  return point.x.bits() <= kBits && point.y.bits() <= kBits;
}

inline bool can_come_back(const Geometry& geometry) {
  const auto all = [](const std::vector<Point>& points) {
    return std::all_of(points.begin(), points.end(),
                       [](const Point& p) { return can_come_back(p); });
  };
  for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
    if (!can_come_back(geometry.region.point(v))) return false;
  }
  return all(geometry.points) &&
         std::all_of(geometry.polylines.begin(), geometry.polylines.end(), all);
}

inline void check_geometry(const Geometry& geometry) {
  if (!can_come_back(geometry)) return;
  for (const Format format : {Format::kWkt, Format::kGeoJson, Format::kPoly}) {
    if (format == Format::kPoly && geometry.has_thin_parts()) continue;
    std::ostringstream out;
    write(out, geometry, format, {Coordinates::Style::kExact});
    require(read_geometry(out.str()) == geometry, "exact text comes back equal");
  }
  const Region& region = geometry.region;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    require(region.exact_x(v).to_double() == region.x(v), "x is the nearest double");
    require(region.exact_y(v).to_double() == region.y(v), "y is the nearest double");
  }
  require(bounding_box(region).has_value() == !region.empty(), "only the empty have no box");
}

/// Returns what `read_it` makes of the text, or nothing if it throws a proper ReadError.
template <typename Read>
auto try_to_read(const std::string& text, Read read_it) -> std::optional<decltype(read_it(text))> {
  try {
    return read_it(text);
  } catch (const ReadError& error) {
    require(error.code() == ErrorCode::kBadInput || error.code() == ErrorCode::kLimitExceeded,
            "a fault of the text has a code for that");
    require((error.line() >= 1 && error.column() >= 1) ||
                std::string_view(error.what()).starts_with("byte ") ||
                std::string_view(error.what()).starts_with("feature "),  // of GDAL
            "a fault has a place");
    require(std::string_view(error.what()).find('\n') == std::string_view::npos,
            "a message is one line");
    return {};
  }
}

/// Returns all features of the text together.
inline Geometry read_features(const std::string& text) {
  Geometry all;
  FeatureReader reader(text);
  while (const auto feature = reader.next()) {
    const Geometry& part = feature->geometry;
    require(!part.empty(), "a feature has a shape");
    for (const std::size_t polygon : part.region.polygons()) {
      all.region.begin_polygon();
      for (const std::size_t ring : part.region.rings_of(polygon)) {
        all.region.begin_ring();
        for (const std::size_t v : part.region.vertices_of(ring)) {
          all.region.add_vertex(part.region.exact_x(v), part.region.exact_y(v));
        }
      }
    }
    all.polylines.insert(all.polylines.end(), part.polylines.begin(), part.polylines.end());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  }
  const SourceInfo& source = reader.source();
  require(source.features >= source.null_geometries + source.empty_geometries, "features count");
  return all;
}

/// Runs the fuzz test of a reader. `prefix` makes the text go to that reader; it may be empty.
inline int fuzz_reader(std::string_view prefix, const std::uint8_t* data, std::size_t size) {
  std::string text(prefix);
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(data[i]);
  const auto region = try_to_read(text, [](const std::string& t) { return read(t); });
  const auto geometry = try_to_read(text, [](const std::string& t) { return read_geometry(t); });
  if (region) {
    require(geometry && *geometry == Geometry{*region, {}, {}}, "a region is that geometry");
  }
  const auto features = try_to_read(text, read_features);
  require(features.has_value() == geometry.has_value(), "features are read where the set is");
  if (!geometry) return 0;
  require(*features == *geometry, "all features together are the set");
  check_geometry(*geometry);
  return 0;
}

}  // namespace minksum::io

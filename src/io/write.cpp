// The writers by format.
#include <sstream>

#include "io/formats.hpp"

namespace minksum::io {

namespace {

void write(std::ostream& out, const GeometryView& geometry, Format format,
           const Coordinates& style) {
  switch (format) {
    case Format::kWkt:
      return write_wkt(out, geometry, style);
    case Format::kGeoJson:
      return write_geojson(out, geometry, style);
    case Format::kPoly:
      if (!geometry.polylines.empty() || !geometry.points.empty()) {
        throw Error(ErrorCode::kBadInput, "polylines and points have no form in .poly");
      }
      return write_poly(out, geometry.region, style);
    case Format::kSvg:
      return write_svg(out, geometry);
    case Format::kDat:
      break;
  }
  throw Error(ErrorCode::kBadInput, "regions are not written as .dat");
}

std::string to_wkt(const GeometryView& geometry, const Coordinates& style) {
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // else a stream out of memory is just a shorter text
  write_wkt(out, geometry, style);
  return std::move(out).str();
}

GeometryView view_of(const Geometry& geometry) {
  return {geometry.region, geometry.polylines, geometry.points};
}

}  // namespace

void write(std::ostream& out, const Region& region, Format format, const Coordinates& style) {
  write(out, GeometryView{region}, format, style);
}

void write(std::ostream& out, const Geometry& geometry, Format format, const Coordinates& style) {
  write(out, view_of(geometry), format, style);
}

std::string to_wkt(const Region& region, const Coordinates& style) {
  return to_wkt(GeometryView{region}, style);
}

std::string to_wkt(const Geometry& geometry, const Coordinates& style) {
  return to_wkt(view_of(geometry), style);
}

}  // namespace minksum::io

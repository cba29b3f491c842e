// Calls the writer of the chosen format.
#include <ostream>

#include "io/formats.hpp"

namespace minksum::io {

namespace {

void write(const Sink& out, const GeometryView& geometry, Format format, const Coordinates& style) {
  require_enumerator(format, Format::kGdal, "format");
  require_enumerator(style.style, Coordinates::Style::kDecimal, "style");
  switch (format) {
    case Format::kWkt:
      return write_wkt(out, geometry, style);
    case Format::kGeoJson:
      return write_geojson(out, geometry, style);
    case Format::kPoly:
      if (!geometry.polylines.empty() || !geometry.points.empty()) {
        refuse_input("polylines and points have no form in .poly");
      }
      return write_poly(out, geometry.region, style);
    case Format::kWkb:
      return write_wkb(out, geometry, style);
    case Format::kHexWkb:
      return write_hex_wkb(out, geometry, style);
    case Format::kSvg:
      return write_svg(out, geometry);
    case Format::kDat:
    case Format::kDxf:
    case Format::kTable:
    case Format::kGdal:
      break;
  }
  refuse_input("regions are not written as .dat, as DXF or as tables");
}

void write(std::ostream& out, const GeometryView& geometry, Format format,
           const Coordinates& style) {
  const auto add = [&out](std::string_view part) {
    out.write(part.data(), static_cast<std::streamsize>(part.size()));
  };
  write(Sink(add), geometry, format, style);
}

std::string to_text(const GeometryView& geometry, Format format, const Coordinates& style) {
  std::string text;
  write(Sink([&text](std::string_view part) { text += part; }), geometry, format, style);
  return text;
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

std::string to_text(const Geometry& geometry, Format format, const Coordinates& style) {
  return to_text(view_of(geometry), format, style);
}

std::string to_wkt(const Region& region, const Coordinates& style) {
  return to_text(GeometryView{region}, Format::kWkt, style);
}

std::string to_wkt(const Geometry& geometry, const Coordinates& style) {
  return to_text(view_of(geometry), Format::kWkt, style);
}

std::string to_geojson(const Region& region, const Coordinates& style) {
  return to_text(GeometryView{region}, Format::kGeoJson, style);
}

std::string to_geojson(const Geometry& geometry, const Coordinates& style) {
  return to_text(view_of(geometry), Format::kGeoJson, style);
}

std::string to_wkb(const Region& region, const Coordinates& style) {
  return to_text(GeometryView{region}, Format::kWkb, style);
}

std::string to_wkb(const Geometry& geometry, const Coordinates& style) {
  return to_text(view_of(geometry), Format::kWkb, style);
}

}  // namespace minksum::io

namespace minksum {

std::ostream& operator<<(std::ostream& out, const Region& region) {
  io::write(out, region, io::Format::kWkt);
  return out;
}

std::ostream& operator<<(std::ostream& out, const Geometry& geometry) {
  io::write(out, geometry, io::Format::kWkt);
  return out;
}

}  // namespace minksum

#include "output/result_file.hpp"

#include <ostream>
#include <utility>

#include "pictures/figure.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

// Returns nothing if no part is lost.
std::string lost_parts(const Geometry& exact, const Geometry& written, RoundingSide side) {
  if (side == RoundingSide::kOutside) return {};  // it contains all parts, even if some become one
  std::string lost;
  const auto count = [&lost](std::size_t before, std::size_t after, const char* what) {
    if (after >= before) return;
    if (!lost.empty()) lost += ", ";
    lost += std::to_string(before - after) + " of " + std::to_string(before) + ' ' + what;
  };
  count(exact.region.polygon_count(), written.region.polygon_count(), "polygons");
  count(exact.region.hole_count(), written.region.hole_count(), "holes");
  count(exact.polylines.size(), written.polylines.size(), "polylines");
  count(exact.points.size(), written.points.size(), "points");
  if (lost.empty()) return {};
  return "rounding loses " + lost +
         ", which vanish or become one with others (--coords exact keeps all)";
}

}  // namespace

RoundOptions rounding_of(const ResultArguments& arguments) {
  RoundOptions target;
  target.side = arguments.rounding;
  if (arguments.coordinates.style == io::Coordinates::Style::kDecimal) {
    target.decimals = arguments.coordinates.digits;
  }
  return target;
}

io::Coordinates in_system_of(const io::Coordinates& coordinates, const io::SourceInfo (&sources)[2],
                             const std::string (&operands)[2]) {
  const auto name = [](const io::SourceInfo& source) {
    const auto srid = io::srid_of(source);
    return srid ? "EPSG:" + std::to_string(*srid) : source.crs;
  };
  const std::string names[2] = {name(sources[0]), name(sources[1])};
  if (!names[0].empty() && !names[1].empty() && names[0] != names[1]) {
    throw Failure(kBadInput, shown_name(operands[1]) + ": the reference system " + names[1] +
                                 " differs from " + names[0] + " of " + shown_name(operands[0]) +
                                 "; transform one of them first");
  }
  const io::SourceInfo& source = sources[names[0].empty() ? 1 : 0];
  io::Coordinates with = coordinates;
  with.srid = source.srid;
  with.crs = source.crs;
  return with;
}

bool has_system(const io::Coordinates& coordinates) {
  return coordinates.srid || !coordinates.crs.empty();
}

void set_system(io::Coordinates& coordinates, const io::Coordinates& system) {
  coordinates.srid = system.srid;
  coordinates.crs = system.crs;
}

void note_lost_system(const io::Coordinates& coordinates, io::Format format) {
  using enum io::Format;
  const bool has_number =
      io::srid_of({.srid = coordinates.srid, .crs = coordinates.crs}).has_value();
  const bool has_place =
      format == kGeoJson || (has_number && (format == kWkt || format == kWkb || format == kHexWkb));
  if (has_place || !has_system(coordinates)) return;
  note("the reference system of the operands has no place in this format");
}

void write_geometry(OutputFiles& files, const std::string& file, const Geometry& geometry,
                    io::Format format, const io::Coordinates& coordinates,
                    const std::string* properties) {
  if (format == io::Format::kSvg) {  // in the style of all other pictures
    Figure figure;
    figure.legend = false;
    figure.layers.push_back({geometry, "sum", "Result"});
    return files.write(file, [&](std::ostream& out) { out << figure_picture(figure); });
  }
  files.write(file, [&](std::ostream& out) {
    if (properties != nullptr) {
      out << R"({"type": "Feature", "properties": )" << *properties << R"(, "geometry": )";
    }
    io::write(out, geometry, format, coordinates);
    if (properties != nullptr) out << '}';
    using enum io::Format;
    if (format == kWkt || format == kGeoJson || format == kHexWkb) out << '\n';
  });
}

Geometry rounded(const Geometry& geometry, const ResultArguments& arguments) {
  if (arguments.coordinates.style == io::Coordinates::Style::kExact) return geometry;
  const RoundOptions target = rounding_of(arguments);
  const Options options{.cancel = arguments.cancel, .progress = arguments.progress};
  const bool may_be_tight = geometry.has_thin_parts() && !geometry.region.empty();
  return may_be_tight ? round_with_tight_places(geometry, target, options)
                      : round(geometry, target, options);
}

Geometry rounded(const Geometry& geometry, const ResultArguments& arguments,
                 std::vector<std::string>& notes) {
  Geometry written = rounded(geometry, arguments);
  std::string lost = lost_parts(geometry, written, arguments.rounding);
  if (!lost.empty()) notes.push_back(std::move(lost));
  return written;
}

void note_lost_parts(const Geometry& exact, const Geometry& written, RoundingSide side) {
  const std::string lost = lost_parts(exact, written, side);
  if (!lost.empty()) note(lost);
}

void write_geometry(OutputFiles& files, const ResultArguments& arguments,
                    const Geometry& geometry) {
  write_geometry(files, arguments.output, geometry, arguments.format, arguments.coordinates);
}

void write_rounded(OutputFiles& files, const ResultArguments& arguments, const Geometry& geometry) {
  const Geometry written = made_for(arguments.output, [&] { return rounded(geometry, arguments); });
  note_lost_parts(geometry, written, arguments.rounding);
  write_geometry(files, arguments, written);
}

}  // namespace minksum::cli

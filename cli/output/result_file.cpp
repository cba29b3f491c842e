#include "output/result_file.hpp"

#include <ostream>

#include "pictures/figure.hpp"
#include "process/failure.hpp"

namespace minksum::cli {

RoundOptions rounding_of(const ResultArguments& arguments) {
  RoundOptions target;
  target.side = arguments.rounding;
  if (arguments.coordinates.style == io::Coordinates::Style::kDecimal) {
    target.decimals = arguments.coordinates.digits;
  }
  return target;
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
    if (format == io::Format::kWkt || format == io::Format::kGeoJson) out << '\n';
  });
}

Geometry rounded(const Geometry& geometry, const ResultArguments& arguments) {
  if (arguments.coordinates.style == io::Coordinates::Style::kExact) return geometry;
  return round(geometry, rounding_of(arguments),
               {.cancel = arguments.cancel, .progress = arguments.progress});
}

void write_geometry(OutputFiles& files, const ResultArguments& arguments,
                    const Geometry& geometry) {
  write_geometry(files, arguments.output, geometry, arguments.format, arguments.coordinates);
}

void write_rounded(OutputFiles& files, const ResultArguments& arguments, const Geometry& geometry) {
  write_geometry(files, arguments,
                 made_for(arguments.output, [&] { return rounded(geometry, arguments); }));
}

}  // namespace minksum::cli

#include "options/drawing_options.hpp"

#include "options/result_options.hpp"
#include "options/typed_numbers.hpp"
#include "process/failure.hpp"

namespace minksum::cli {

void add_drawing_options(const Command& command, io::DrawingOptions& drawing, bool has_tolerance) {
  constexpr const char* kGroup = "Operands that are drawings (SVG, DXF)";
  if (!has_tolerance) {
    command
        .add_option(
            "--tolerance",
            [&drawing](const std::string& text) {
              drawing.tolerance = parse_number("--tolerance", text);
              if (drawing.tolerance->sign() > 0) return;
              throw Failure(kWrongUsage, "--tolerance must be positive");
            },
            "How far the polyline of a curve may be off, in the unit of the drawing")
        .type_name("T")
        .group(kGroup);
    add_choice(command, "--side", rounding_sides(), drawing.side,
               "nearest (the default), outside (areas contain those of the drawing), inside")
        .type_name("SIDE")
        .group(kGroup);
  }
  command
      .add_option("--layer", drawing.layer, "Read this layer alone, also of files that GDAL opens")
      .type_name("NAME")
      .group(kGroup);
  command
      .add_option(
          "--join-ends",
          [&drawing](const std::string& text) {
            drawing.join_ends = parse_number("--join-ends", text);
            if (drawing.join_ends.sign() >= 0) return;
            throw Failure(kWrongUsage, "--join-ends must not be negative");
          },
          "Join ends of outlines that are at most so far apart (default: equal ends)")
      .type_name("D")
      .group(kGroup);
}

}  // namespace minksum::cli

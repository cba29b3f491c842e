// minksum nfp and ifp: tell where a part can be placed.
#include <memory>
#include <ostream>

#include "commands/commands.hpp"
#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

const char* to_string(Contact contact) {
  constexpr const char* kNames[] = {"free", "touching", "overlapping"};
  return kNames[static_cast<std::size_t>(contact)];
}

Geometry without_thin_parts(const Geometry& geometry) { return {geometry.region, {}, {}}; }

Geometry thin_parts_of(const Geometry& geometry) {
  return {{}, geometry.polylines, geometry.points};
}

void draw(const NoFitArguments& arguments, const Geometry& fixed, const Geometry& moving,
          const Geometry& polygon, OutputFiles& files) {
  const Options reading{.fill = arguments.options.fill, .regularize = true};
  const Geometry area = without_thin_parts(polygon);
  const Geometry tight = thin_parts_of(polygon);
  const Captions captions = arguments.inner_fit
                                ? Captions{"Inner-fit polygon", "Bin", "Part", "Inner-fit polygon"}
                                : Captions{"No-fit polygon", "Fixed", "Moving", "No-fit polygon"};
  // A part without a first vertex would have failed before this point.
  const Point mark = arguments.reference ? *arguments.reference : moving.region.point(0);
  write_picture(
      files, arguments.picture,
      {resolve(fixed, reading), resolve(moving, reading), area, &tight, captions, true, mark});
}

void write_contacts(const NoFitArguments& arguments, const Geometry& fixed,
                    const Geometry& moving) {
  const std::vector<const char*> answers = contacts(arguments, fixed, moving);
  write_standard_output([&](std::ostream& out) {
    for (const char* const answer : answers) out << answer << '\n';
  });
}

}  // namespace

Geometry fit_polygon(const NoFitArguments& arguments, const Geometry& fixed,
                     const Geometry& moving) {
  return arguments.inner_fit
             ? inner_fit_polygon(fixed, moving, arguments.reference, arguments.options)
             : no_fit_polygon(fixed, moving, arguments.reference, arguments.options);
}

Geometry rounded_fit_polygon(const NoFitArguments& arguments, const Geometry& polygon) {
  if (arguments.inner_fit) return rounded(polygon, arguments);
  // The tight places of a no-fit polygon lie within its area. As parts of one set they would
  // vanish in it, so they are rounded separately.
  ResultArguments nearest = arguments;
  nearest.rounding = RoundingSide::kNearest;
  Geometry result = rounded(without_thin_parts(polygon), arguments);
  Geometry tight = rounded(thin_parts_of(polygon), nearest);
  result.polylines = std::move(tight.polylines);
  result.points = std::move(tight.points);
  return result;
}

std::vector<const char*> contacts(const NoFitArguments& arguments, const Geometry& fixed,
                                  const Geometry& moving) {
  const NoFitPolygon polygon(fixed, moving, arguments.reference, arguments.options);
  std::vector<const char*> answers;
  for (const Point& placement : arguments.placements) {
    answers.push_back(to_string(polygon.contact(placement)));
  }
  return answers;
}

namespace {

int run_no_fit(const NoFitArguments& arguments) {
  bool fits = true;
  run_on_operands(arguments, arguments.output,
                  [&](const Geometry& fixed, const Geometry& moving, OutputFiles& files) {
                    if (!arguments.placements.empty()) {
                      return write_contacts(arguments, fixed, moving);
                    }
                    const Geometry polygon = fit_polygon(arguments, fixed, moving);
                    write_geometry(files, arguments, made_for(arguments.output, [&] {
                                     return rounded_fit_polygon(arguments, polygon);
                                   }));
                    if (!arguments.picture.empty()) draw(arguments, fixed, moving, polygon, files);
                    fits = !polygon.empty();
                  });
  if (arguments.inner_fit && !fits) {
    note("the part (" + shown_name(arguments.operands[1]) + ") does not fit into the bin (" +
         shown_name(arguments.operands[0]) + ")");
  }
  return kFine;
}

}  // namespace

void add_no_fit(Program& program) {
  for (const bool inner_fit : {false, true}) {
    NoFitArguments arguments;
    arguments.inner_fit = inner_fit;
    program.add(add_no_fit, run_no_fit, arguments);
  }
}

}  // namespace minksum::cli

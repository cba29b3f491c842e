// Computes what the subcommands for uses of sums compute, without files. `minksum batch` uses it,
// too. All functions throw Error, whose culprit names the operand.
#pragma once

#include <optional>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

#include "batch/each_feature.hpp"
#include "commands/commands.hpp"
#include "output/json.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "output/statistics_json.hpp"
#include "process/failure.hpp"
#include "process/stopwatch.hpp"

namespace minksum::cli {

/// Reads the operands, lets `work(arguments, a, b, files)` compute and write with them, and moves
/// all files to their places. `work` gets arguments that name the reference system.
template <class Arguments, class Work>
void run_on_operands(const Arguments& given, Work work) {
  constexpr bool has_result = std::is_base_of_v<ResultArguments, Arguments>;
  Arguments arguments = given;
  OutputFiles files;
  if constexpr (has_result) {
    files.expect("-o", arguments.output);
  } else {
    files.expect("-o", "");
  }
  files.expect_if_any("--svg", arguments.picture);
  files.expect_if_any("--stats", arguments.stats);
  OperationSeconds seconds;
  const Stopwatch reading;
  Geometry operands[2];
  io::SourceInfo sources[2];
  for (int i = 0; i < 2 && !arguments.operands[i].empty(); ++i) {
    io::Document operand =
        read_operand(arguments.operands[i], arguments.limits, arguments.options.fill);
    operands[i] = std::move(operand.geometry);
    sources[i] = std::move(operand.source);
  }
  const io::Coordinates coordinates = in_system_of({}, sources, arguments.operands);
  if constexpr (has_result) {
    arguments.coordinates.srid = coordinates.srid;
    arguments.coordinates.crs = coordinates.crs;
    note_lost_system(coordinates, arguments.format);
  }
  seconds.read = reading.seconds();
  const Stopwatch working;
  try {
    work(arguments, operands[0], operands[1], files);
  } catch (const Error& error) {
    fail_about(error, arguments.operands);
  }
  seconds.work = working.seconds();
  if (!arguments.stats.empty()) {
    const Json json = statistics_json(arguments, operands, seconds);
    files.write(arguments.stats, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
  }
  files.finish();
}

/// Runs an operation whose result is a geometry: on all features as one set, or on each. `compute`
/// and `draw` get the arguments, the operands, and `draw` the exact result as well.
template <class Arguments, class Compute, class Draw>
int run_operation(const Arguments& arguments, Compute compute, Draw draw) {
  if (arguments.each) {
    return run_each(arguments, [compute](const Arguments& mine, const Geometry& a,
                                         const Geometry& b, Worker& worker) {
      return rounded(compute(mine, a, b), mine, worker.notes);
    });
  }
  run_on_operands(arguments, [&](const Arguments& mine, const Geometry& a, const Geometry& b,
                                 OutputFiles& files) {
    const Geometry result = compute(mine, a, b);
    write_rounded(files, mine, result);
    if (!mine.picture.empty()) draw(mine, a, b, result, files);
  });
  return kFine;
}

/// Returns the exact dilation, erosion, opening or closing.
[[nodiscard]] Geometry morphology(const MorphologyArguments& arguments, const Geometry& a,
                                  const Geometry& b);

/// Returns the exact union, intersection, difference or symmetric difference.
[[nodiscard]] Geometry combined(const BooleanArguments& arguments, const Geometry& a,
                                const Geometry& b);
/// Returns the set transformed exactly; for output as doubles, some coordinates are rounded
/// already.
[[nodiscard]] Geometry image(const TransformArguments& arguments, const Geometry& set);

/// Returns the point of the moving part that says where it is. Nothing if that is its first vertex
/// and there is none, which the operation refuses. Throws Error(kBadInput) if a part without area
/// has no such point.
[[nodiscard]] std::optional<Point> reference_of(const NoFitArguments& arguments,
                                                const Geometry& moving);

/// Returns the exact no-fit or inner-fit polygon with its tight places.
[[nodiscard]] Geometry fit_polygon(const NoFitArguments& arguments, const Geometry& fixed,
                                   const Geometry& moving);
/// Returns "free", "touching" or "overlapping" for each of the requested placements.
[[nodiscard]] std::vector<const char*> contacts(const NoFitArguments& arguments,
                                                const Geometry& fixed, const Geometry& moving);

/// Returns them as JSON, with the reference point: {"contacts": [...], "reference": ["x", "y"]}.
[[nodiscard]] Json contacts_json(const std::vector<const char*>& answers,
                                 const std::optional<Point>& reference);

/// Names a vertex, or the edge that starts there, by its position in an operand.
struct Feature {
  const char* operand;
  Culprit place;
};
/// An edge and a vertex that touch. The edge is named by its first vertex.
struct ContactList {
  Feature edge;
  Feature vertex;
};
/// Tells how two shapes stand to each other.
struct DepthReport {
  Depth depth;
  std::optional<ContactList> contacts;
  std::optional<Rational> impact;  ///< set if it was asked for and the shapes meet
};
[[nodiscard]] DepthReport find_depth(const DepthArguments& arguments, const Geometry& a,
                                     const Geometry& b);
/// Returns the report as JSON, with the keys that docs/operations.md describes.
[[nodiscard]] Json depth_json(const DepthArguments& arguments, const DepthReport& findings);

}  // namespace minksum::cli

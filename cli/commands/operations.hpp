// Computes what the subcommands for uses of sums compute, without files. `minksum batch` uses it,
// too. All functions throw Error, whose culprit names the operand.
#pragma once

#include <ostream>
#include <vector>

#include "commands/commands.hpp"
#include "output/json.hpp"
#include "output/output_file.hpp"
#include "output/statistics_json.hpp"
#include "process/failure.hpp"
#include "process/stopwatch.hpp"

namespace minksum::cli {

/// Reads the operands, lets `work` compute and write with them, and moves all files to their
/// places. `output` names the file of the result; empty = standard output.
template <class Work>
void run_on_operands(const OperandArguments& arguments, const std::string& output, Work work) {
  OutputFiles files;
  files.expect("-o", output);
  files.expect_if_any("--svg", arguments.picture);
  files.expect_if_any("--stats", arguments.stats);
  OperationSeconds seconds;
  const Stopwatch reading;
  Geometry operands[2];
  for (int i = 0; i < 2 && !arguments.operands[i].empty(); ++i) {
    operands[i] =
        read_operand(arguments.operands[i], arguments.limits, arguments.options.fill).geometry;
  }
  seconds.read = reading.seconds();
  const Stopwatch working;
  try {
    work(operands[0], operands[1], files);
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

/// Returns the exact dilation, erosion, opening or closing.
[[nodiscard]] Geometry morphology(const MorphologyArguments& arguments, const Geometry& a,
                                  const Geometry& b);

/// Returns the exact no-fit or inner-fit polygon with its tight places.
[[nodiscard]] Geometry fit_polygon(const NoFitArguments& arguments, const Geometry& fixed,
                                   const Geometry& moving);
/// Returns that polygon rounded for output; tight places are rounded to the nearest.
[[nodiscard]] Geometry rounded_fit_polygon(const NoFitArguments& arguments,
                                           const Geometry& polygon);
/// Returns "free", "touching" or "overlapping" for each of the requested placements.
[[nodiscard]] std::vector<const char*> contacts(const NoFitArguments& arguments,
                                                const Geometry& fixed, const Geometry& moving);

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

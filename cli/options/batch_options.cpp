#include "commands/batch.hpp"
#include "options/sum_options.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kFooter = R"(
JOBS has a JSON object a line: "operation" (sum, dilate, erode, open, close, nfp,
ifp, depth, offset, union, intersection, difference, symdiff, transform, reflect,
convert), "a" and "b" (the path of a file, {"wkt": "..."}, or GeoJSON), "options"
(named as on the command line), "id". Results are lines in the same order. A job
that fails is a line with "error"; the exit code is 2 then.
)";

constexpr int kMaxThreads = 1024;
constexpr int kMaxRotations = 3600;

void add_pair_options(const Command& command, BatchArguments& arguments) {
  const char* const group = "All pairs (instead of JOBS)";
  command
      .add_option("--pairs", arguments.pairs,
                  "All ordered pairs of the parts in this folder, each with itself as well")
      .type_name("DIR")
      .group(group);
  command
      .add_option("--rotations", arguments.rotations,
                  "The second part turned by k/R of a full turn, k = 0 to R-1 (default 1)")
      .in_range(1, kMaxRotations)
      .type_name("R")
      .group(group);
  command.add_option("--operation", arguments.operation, "nfp (the default) or sum")
      .one_of({"nfp", "sum"})
      .needs("--pairs")
      .type_name("OP")
      .group(group);
  command.add_flag("--tight", arguments.tight, "No-fit polygons with tight places").group(group);
  command.add_flag("--no-output", arguments.no_output, "Compute only, write nothing").group(group);
}

}  // namespace

Command describe_batch(CommandLine& line, BatchArguments& arguments, ProcessLimits& limits) {
  const Command command = line.add_command("batch", "Many operations, on all cores");
  command.footer(kFooter);
  command.add_option("JOBS", arguments.jobs, "The jobs, or - for standard input").type_name("FILE");
  add_result_options(command, arguments, "results");
  add_fill_option(command, arguments.fill);
  command.add_option("--threads", arguments.threads, "How many (default: as the machine has)")
      .in_range(1, kMaxThreads)
      .type_name("N");
  command.add_flag("--restart", arguments.restart,
                   "Start afresh, even if an earlier run left FILE.partial");
  command.add_option("--stats", arguments.stats, "Write counts and times as JSON")
      .type_name("FILE");
  add_pair_options(command, arguments);
  add_limit_options(command, limits, true);
  command.remove_option("--timeout");
  add_seconds(command, arguments.seconds, "Time for each job (default: none)");
  return command;
}

void convert(BatchArguments& arguments) {
  convert_numbers(arguments);
  const std::string& format = arguments.typed_format;
  // The ending of the output's name does not matter.
  arguments.format = format == "geojson" ? io::Format::kGeoJson : io::Format::kWkt;
  if (!format.empty() && format != "wkt" && format != "geojson") {
    throw Failure(kWrongUsage, "--format takes wkt or geojson here");
  }
  arguments.limits.seconds = arguments.seconds;
  if (arguments.jobs.empty() == arguments.pairs.empty()) {
    throw Failure(kWrongUsage, "either JOBS or --pairs DIR");
  }
  const bool pairs = !arguments.pairs.empty();
  if (!pairs && (arguments.rotations != 1 || arguments.tight || arguments.no_output)) {
    throw Failure(kWrongUsage, "--rotations, --tight and --no-output need --pairs");
  }
  if (arguments.tight && arguments.operation != "nfp") {
    throw Failure(kWrongUsage, "--tight needs --operation nfp");
  }
  if (arguments.no_output && !arguments.output.empty()) {
    throw Failure(kWrongUsage, "-o and --no-output exclude each other");
  }
  if (arguments.stats == "-" && arguments.output.empty() && !arguments.no_output) {
    throw Failure(kWrongUsage, "--stats - needs -o FILE: standard output already takes results");
  }
  const std::pair<const char*, std::string> defaults[] = {
      {"format", format},
      {"coords", arguments.typed_coordinates == "double" ? "" : arguments.typed_coordinates},
      {"round", arguments.typed_rounding},
      {"fill", arguments.fill == FillRule::kAutomatic ? "" : to_string(arguments.fill)}};
  for (const auto& [name, value] : defaults) {
    if (value.empty()) continue;
    arguments.defaults.push_back({name,
                                  {"--" + std::string(name) + "=" + value},
                                  false,
                                  std::make_shared<std::atomic<bool>>(false)});
  }
  arguments.threads = threads_or_all(arguments.threads);
}

}  // namespace minksum::cli

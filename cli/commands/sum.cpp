// minksum sum: reads two geometries, adds them, and writes the sum and any other output.
#include <cstdio>
#include <optional>
#include <ostream>

#include "batch/each_feature.hpp"
#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "options/sum_options.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "output/statistics_json.hpp"
#include "output/trace_files.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"
#include "process/stopwatch.hpp"

namespace minksum::cli {
namespace {

using Style = io::Coordinates::Style;

void expect_files(const SumArguments& arguments, OutputFiles& files) {
  files.expect("-o", arguments.output);
  files.expect_if_any("--tight", arguments.tight);
  files.expect_if_any("--stats", arguments.stats);
  files.expect_if_any("--svg", arguments.picture);
  if (arguments.trace.empty()) return;
  make_folder(arguments.trace);
  for (const char* const name : kTraceFiles) {
    files.expect_own("--trace", arguments.trace + '/' + name);
  }
}

void read_operands(SumArguments& arguments, SumRun& run) {
  const Stopwatch watch;
  io::SourceInfo sources[2];
  for (int i = 0; i < 2; ++i) {
    io::Document operand =
        read_operand(arguments.operands[i], arguments.limits, arguments.options.fill);
    run.operands[i] = std::move(operand.geometry);
    sources[i] = std::move(operand.source);
    if (i == 0) run.properties = std::move(operand.properties);
  }
  arguments.coordinates = in_system_of(arguments.coordinates, sources, arguments.operands);
  note_lost_system(arguments.coordinates, arguments.format);
  run.seconds.read = watch.seconds();
  if (arguments.keep_properties && !run.properties) {
    throw failure_of(
        Error(ErrorCode::kBadInput, "--keep-properties needs a single GeoJSON Feature"),
        arguments.operands[0]);
  }
}

// Runs the sum `repeat` times in the same memory; what is kept is the last run's.
void compute(const SumArguments& arguments, SumRun& run) {
  Workspace memory;
  SumSettings settings = arguments.options;
  settings.memory = &memory;
  settings.tight = !arguments.tight.empty();
  std::vector<double> sums;
  std::vector<double> stages[kSumStages];
  for (int i = 0; i < arguments.repeat; ++i) {
    const Stopwatch watch;
    DetailedSum sum = detailed_sum(run.operands[0], run.operands[1], settings);
    sums.push_back(watch.seconds());
    run.exact = std::move(sum.sum);
    if (*settings.tight) run.tight = std::move(sum.tight);
    run.statistics = sum.statistics;
    for (int s = 0; s < kSumStages; ++s) stages[s].push_back(run.statistics.stage_seconds[s]);
  }
  run.seconds.sum = median(sums);
  for (int s = 0; s < kSumStages; ++s) run.seconds.stages[s] = median(stages[s]);
}

// Tracing takes a separate run, so that the times are those of plain runs.
void compute_and_write_trace(const SumArguments& arguments, SumRun& run, OutputFiles& files) {
  const DetailedSum traced =
      detailed_sum(run.operands[0], run.operands[1], arguments.options, Detail::kTrace);
  run.statistics = traced.statistics;  // the counts go with the pictures
  made_for(arguments.trace, [&] {
    write_trace(files, arguments.trace, drawing_of(run, arguments.options), traced.trace);
  });
}

// Rounds the result as a whole, so that it stays valid.
void round_result(const SumArguments& arguments, SumRun& run) {
  if (arguments.coordinates.style == Style::kExact) return;
  const Stopwatch watch;
  RoundOptions target = rounding_of(arguments);
  Rounded rounded = made_for(arguments.output, [&] {
    return detailed_round(run.exact, target, {.progress = arguments.progress});
  });
  run.rounded = std::move(rounded.geometry);
  run.rounding = rounded.report;
  note_lost_parts(run.exact, run.rounded, target.side);
  target.side = RoundingSide::kNearest;
  if (run.tight) {
    run.rounded_tight = made_for(arguments.tight, [&] { return round(*run.tight, target); });
    note_lost_parts(*run.tight, run.rounded_tight, target.side);
  }
  run.seconds.round = watch.seconds();
}

void write_results(const SumArguments& arguments, SumRun& run, OutputFiles& files) {
  const Stopwatch watch;
  write_geometry(files, arguments.output, run.rounding ? run.rounded : run.exact, arguments.format,
                 arguments.coordinates, arguments.keep_properties ? &*run.properties : nullptr);
  run.seconds.write = watch.seconds();
  if (run.tight) {
    write_geometry(files, arguments.tight, run.rounding ? run.rounded_tight : *run.tight,
                   arguments.tight_format, arguments.coordinates);
  }
  if (!arguments.picture.empty()) {
    write_picture(files, arguments.picture, drawing_of(run, arguments.options));
  }
  if (!arguments.stats.empty()) {
    const Json json = statistics_json(arguments, run);
    files.write(arguments.stats, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
  }
}

void tell_summary(const SumArguments& arguments, const SumRun& run) {
  std::fprintf(stderr, "P      %s\nQ      %s\nP + Q  %s\n", summary(run.operands[0]).c_str(),
               summary(run.operands[1]).c_str(), summary(run.exact).c_str());
  if (run.tight) std::fprintf(stderr, "tight  %s\n", summary(*run.tight).c_str());
  const std::string runs =
      arguments.repeat > 1 ? " (median of " + std::to_string(arguments.repeat) + " runs)" : "";
  std::fprintf(stderr, "time   %s%s\n", readable_seconds(run.seconds.sum).c_str(), runs.c_str());
}

Geometry sum_of_feature(const SumArguments& arguments, const Geometry& p, const Geometry& q,
                        Worker& worker) {
  SumSettings settings = arguments.options;
  settings.memory = &worker.memory;
  return rounded(minkowski_sum(p, q, settings), arguments, worker.notes);
}

int run_sum(const SumArguments& given) {
  if (given.each) return run_each(given, sum_of_feature);
  SumArguments arguments = given;
  OutputFiles files;
  expect_files(arguments, files);
  SumRun run;
  read_operands(arguments, run);
  try {
    compute(arguments, run);
    if (!arguments.trace.empty()) compute_and_write_trace(arguments, run, files);
    round_result(arguments, run);
  } catch (const Error& error) {
    fail_about(error, arguments.operands);
  }
  write_results(arguments, run, files);
  files.finish();
  if (arguments.verbose) tell_summary(arguments, run);
  return kFine;
}

}  // namespace

void add_sum(Program& program) { program.add(describe_sum, run_sum); }

}  // namespace minksum::cli

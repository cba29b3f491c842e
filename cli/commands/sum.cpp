// minksum sum: reads two geometries, adds them, and writes the sum and any other output.
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>

#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "options/sum_options.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "output/statistics_json.hpp"
#include "output/trace_files.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

using Style = io::Coordinates::Style;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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

void read_operands(const SumArguments& arguments, SumRun& run) {
  const Stopwatch watch;
  for (int i = 0; i < 2; ++i) {
    ReadOperand operand =
        read_operand(arguments.operands[i], arguments.limits, arguments.options.fill);
    run.operands[i] = std::move(operand.geometry);
    if (i == 0) run.properties = std::move(operand.properties);
  }
  run.seconds.read = watch.seconds();
  if (arguments.keep_properties && !run.properties) {
    throw failure_of(
        Error(ErrorCode::kBadInput, "--keep-properties needs a single GeoJSON Feature"),
        arguments.operands[0]);
  }
}

// Runs the sum `repeat` times in the same memory. The statistics and the result are those of the
// last run.
void compute(const SumArguments& arguments, SumRun& run) {
  Workspace workspace;
  std::vector<double> sums;
  std::vector<double> stages[kStageCount];
  for (int i = 0; i < arguments.repeat; ++i) {
    run.statistics = Statistics();
    Options options = arguments.options;
    options.statistics = &run.statistics;
    if (!arguments.tight.empty()) options.tight = &run.tight.emplace();
    const Stopwatch watch;
    const Outcome outcome =
        minkowski_sum(run.operands[0], run.operands[1], options, workspace, run.exact);
    sums.push_back(watch.seconds());
    if (!outcome.ok()) fail_about(*outcome.error, arguments.operands);
    for (int s = 0; s < kStageCount; ++s) stages[s].push_back(run.statistics.stage_seconds[s]);
  }
  run.seconds.sum = median(sums);
  for (int s = 0; s < kStageCount; ++s) run.seconds.stages[s] = median(stages[s]);
}

// Tracing takes a separate run, so that the times are those of plain runs.
void compute_and_write_trace(const SumArguments& arguments, const SumRun& run, OutputFiles& files) {
  Trace trace;
  Options options = arguments.options;
  options.trace = &trace;
  static_cast<void>(minkowski_sum(run.operands[0], run.operands[1], options));
  made_for(arguments.trace,
           [&] { write_trace(files, arguments.trace, drawing_of(run, arguments.options), trace); });
}

// Rounds the result as a whole, so that it stays valid.
void round_result(const SumArguments& arguments, SumRun& run) {
  if (arguments.coordinates.style == Style::kExact) return;
  const Stopwatch watch;
  RoundOptions options = rounding_of(arguments);
  run.rounded = made_for(arguments.output,
                         [&] { return round(run.exact, options, &run.rounding.emplace()); });
  options.side = RoundingSide::kNearest;
  if (run.tight) {
    run.rounded_tight = made_for(arguments.tight, [&] { return round(*run.tight, options); });
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
    files.write(arguments.picture,
                [&](std::ostream& out) { out << sum_picture(drawing_of(run, arguments.options)); });
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

}  // namespace

int run_sum(const SumArguments& arguments) {
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

void add_sum(Program& program) {
  const auto arguments = std::make_shared<SumArguments>();
  const auto typed = std::make_shared<SumText>();
  program.add(add_sum(program.line, *arguments, *typed, program.limits), arguments, typed, run_sum);
}

}  // namespace minksum::cli

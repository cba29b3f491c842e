// minksum sum: read two regions, add them, write the sum and what is asked for beside it.
#include <chrono>
#include <cstdio>
#include <new>
#include <optional>
#include <ostream>

#include "commands.hpp"
#include "failure.hpp"
#include "output_file.hpp"
#include "statistics_json.hpp"
#include "sum_picture.hpp"
#include "trace_files.hpp"

namespace minksum::cli {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// An error that the library raised about its operands, told with the operand's file.
Failure sum_failure(const Error& error, const SumArguments& arguments) {
  const int operand = error.culprit().operand;
  return failure_of(error, operand == 0 || operand == 1 ? arguments.operands[operand] : "");
}

[[noreturn]] void fail(const Error& error, const SumArguments& arguments) {
  // So the library tells it where it throws nothing; the program has a line for this.
  if (error.code() == ErrorCode::kLimitExceeded && error.what() == std::string("out of memory")) {
    throw std::bad_alloc();
  }
  throw sum_failure(error, arguments);
}

// Runs the sum `repeat` times in the same memory; `statistics` and `result` are the last run's.
void compute(const SumArguments& arguments, const Region (&operands)[2], Region& result,
             Statistics& statistics, Seconds& seconds) {
  Workspace workspace;
  std::vector<double> sums;
  std::vector<double> stages[kStageCount];
  for (int run = 0; run < arguments.repeat; ++run) {
    statistics = Statistics();
    Options options = arguments.options;
    options.statistics = &statistics;
    const Stopwatch watch;
    const Outcome outcome = minkowski_sum(operands[0], operands[1], options, workspace, result);
    sums.push_back(watch.seconds());
    if (!outcome.ok()) fail(*outcome.error, arguments);
    for (int i = 0; i < kStageCount; ++i) stages[i].push_back(statistics.stage_seconds[i]);
  }
  seconds.sum = median(sums);
  for (int i = 0; i < kStageCount; ++i) seconds.stages[i] = median(stages[i]);
}

// Tracing takes a run of its own, so that the times are those of plain runs.
void compute_and_write_trace(const SumArguments& arguments, const Region (&operands)[2]) {
  Trace trace;
  Options options = arguments.options;
  options.trace = &trace;
  const Region result = minkowski_sum(operands[0], operands[1], options);
  write_trace(arguments.trace, operands[0], operands[1], result, trace);
}

void tell_summary(const Region (&operands)[2], const Region& result, const SumArguments& arguments,
                  const Seconds& seconds) {
  std::fprintf(stderr, "P      %s\nQ      %s\nP + Q  %s\n", summary(operands[0]).c_str(),
               summary(operands[1]).c_str(), summary(result).c_str());
  const std::string runs =
      arguments.repeat > 1 ? " (median of " + std::to_string(arguments.repeat) + " runs)" : "";
  std::fprintf(stderr, "time   %s%s\n", readable_seconds(seconds.sum).c_str(), runs.c_str());
}

}  // namespace

int run_sum(const SumArguments& arguments) {
  for (const std::string* path : {&arguments.output, &arguments.stats, &arguments.picture}) {
    check_writable(*path);
  }
  if (!arguments.trace.empty()) make_folder(arguments.trace);

  Seconds seconds;
  const Stopwatch reading;
  const Region operands[2] = {read_operand(arguments.operands[0], arguments.limits),
                              read_operand(arguments.operands[1], arguments.limits)};
  seconds.read = reading.seconds();

  Region result;
  Statistics statistics;
  try {
    compute(arguments, operands, result, statistics, seconds);
    if (!arguments.trace.empty()) compute_and_write_trace(arguments, operands);
  } catch (const Error& error) {
    fail(error, arguments);
  }

  const Stopwatch writing;
  write_output(arguments.output, [&](std::ostream& out) {
    io::write(out, result, arguments.format, arguments.coordinates);
    const bool one_line =
        arguments.format == io::Format::kWkt || arguments.format == io::Format::kGeoJson;
    if (one_line) out << '\n';
  });
  seconds.write = writing.seconds();

  if (!arguments.picture.empty()) {
    const std::string picture = sum_picture(operands[0], operands[1], result);
    write_output(arguments.picture, [&](std::ostream& out) { out << picture; });
  }
  if (!arguments.stats.empty()) {
    const auto json = statistics_json(arguments, operands, result, statistics, seconds);
    write_output(arguments.stats, [&](std::ostream& out) {
      out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    });
  }
  if (arguments.verbose) tell_summary(operands, result, arguments, seconds);
  return kFine;
}

}  // namespace minksum::cli

// The program: arguments in, exit code out. Each subcommand has a file of its own.
#include <CLI/CLI.hpp>
#include <ostream>
#include <string>

#include "commands.hpp"
#include "failure.hpp"
#include "limits.hpp"
#include "minksum/version.hpp"
#include "output_file.hpp"
#include "process.hpp"
#include "sum_options.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kFooter = R"(
Exit codes: 0 fine, 1 wrong usage, 2 bad input or unwritable output,
3 a stated limit exceeded, 4 internal error (with the stage's name),
5 `check` found that a result is wrong.
Errors are one line on standard error: "minksum: FILE:LINE:COLUMN: what", or
"minksum: FILE: polygon K, ring R, vertex V: what"; all of these count from 1,
and ring 1 is the outer one.)";

void add_info(CLI::App& app, InfoArguments& arguments, ProcessLimits& limits) {
  CLI::App* info = app.add_subcommand(
      "info", "What a geometry is: parts, holes, box, exact area, validity, bits");
  info->footer("\nExit code 2 if polygons are not valid as they stand; all faults are listed.\n");
  info->add_option("FILE", arguments.file, "The geometry, or - for standard input")
      ->required()
      ->type_name("FILE");
  info->add_flag("--json", arguments.json, "As JSON");
  add_fill_option(*info, arguments.resolve.fill);
  info->add_flag("--regularize", arguments.resolve.regularize, "Drop polylines, points and spikes");
  add_limit_options(*info, limits, false);
}

void add_check(CLI::App& app, CheckArguments& arguments, ProcessLimits& limits) {
  CLI::App* check = app.add_subcommand(
      "check", "Whether a result, of minksum or of any program, is the sum of two geometries");
  check->footer(
      "\nDecided by other methods than `sum` uses: validity; points near edges and at random;\n"
      "and, where it is small enough for the second method, the whole sum exactly. Rounded results\n"
      "need --within. Exit code 5 if an error is found.\n");
  const auto add_file = [check](const char* name, std::string& file, const char* what) {
    check->add_option(name, file, what)->required()->type_name("FILE");
  };
  add_file("RESULT", arguments.result, "What is said to be the sum");
  add_file("P", arguments.operands[0], "The first operand");
  add_file("Q", arguments.operands[1], "The second operand");
  add_fill_option(*check, arguments.options.fill);
  check->add_flag("--regularize", arguments.options.regularize,
                  "Drop operands' polylines, points and spikes");
  check->add_option_function<std::string>(
           "--within",
           [&arguments](const std::string& text) {
             const auto value = Rational::parse(text);
             if (!value || value->sign() < 0) {
               throw CLI::ValidationError("--within", "takes a number that is not negative, not '" +
                                                          text + "'");
             }
             arguments.options.within = *value;
           },
           "How far, in x and in y, the result may be off; 0, the default: not at all")
      ->type_name("D");
  check->add_option("--samples", arguments.options.samples,
                    "Random points, beside those near edges; 1000 without it")
      ->type_name("N");
  check->add_option("--edges", arguments.options.edges,
                    "Edges of the result near which points are tested; 10000 without it")
      ->type_name("N");
  check->add_option("--seed", arguments.options.seed, "Seed of the random points")->type_name("N");
  check->add_option("--proof-segments", arguments.options.limits.max_segments,
                    "Largest signed convolution for which the whole sum is compared")
      ->type_name("N");
  check->add_flag("--json", arguments.json, "As JSON");
  add_limit_options(*check, limits, false);
}

int run(int argc, char** argv, ProcessLimits& limits) {
  CLI::App app("Exact Minkowski sums in the plane", "minksum");
  app.set_version_flag("--version", "minksum " MINKSUM_VERSION);
  app.require_subcommand(1);

  SumArguments sum_arguments;
  TypedSum typed;
  InfoArguments info_arguments;
  CheckArguments check_arguments;
  add_sum(app, sum_arguments, typed, limits);
  add_info(app, info_arguments, limits);
  add_check(app, check_arguments, limits);
  for (CLI::App* const command : app.get_subcommands({})) {
    command->footer(command->get_footer() + kFooter);
  }
  app.footer(kFooter);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help and --version
    int code = kFine;
    write_output("", [&](std::ostream& out) { code = app.exit(success, out, out); });
    return code;
  } catch (const CLI::ParseError& error) {
    throw Failure(kWrongUsage, std::string(error.what()) + " (minksum --help)");
  }
  apply(limits);
  if (app.got_subcommand("info")) {
    info_arguments.limits = limits.read;
    return run_info(info_arguments);
  }
  if (app.got_subcommand("check")) {
    check_arguments.limits = limits.read;
    return run_check(check_arguments);
  }
  sum_arguments.limits = limits.read;
  sum_arguments.options.limits = limits.sum;
  settle(sum_arguments, typed);
  return run_sum(sum_arguments);
}

}  // namespace
}  // namespace minksum::cli

int main(int argc, char** argv) {
  namespace cli = minksum::cli;
  cli::ProcessLimits limits;
  try {
    cli::prepare_process();
    return cli::run(argc, argv, limits);
  } catch (...) {
    return cli::report_failure(limits.memory);
  }
}

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
3 a stated limit exceeded, 4 internal error (with the stage's name).
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

int run(int argc, char** argv, ProcessLimits& limits) {
  CLI::App app("Exact Minkowski sums in the plane", "minksum");
  app.set_version_flag("--version", "minksum " MINKSUM_VERSION);
  app.require_subcommand(1);

  SumArguments sum_arguments;
  TypedSum typed;
  InfoArguments info_arguments;
  CLI::App* const sum = add_sum(app, sum_arguments, typed, limits);
  add_info(app, info_arguments, limits);
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
  if (!sum->parsed()) {
    info_arguments.limits = limits.read;
    return run_info(info_arguments);
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

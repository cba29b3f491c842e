// Runs the program: parses the arguments, calls the chosen subcommand, returns its exit code.
#include <ostream>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "minksum/version.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "output/output_file.hpp"
#include "process/failure.hpp"
#include "process/process.hpp"

namespace minksum::cli {
namespace {

constexpr const char* kFooter = R"(
Exit codes: 0 fine, 1 wrong usage, 2 bad input or unwritable output,
3 a stated limit exceeded, 4 internal error (with the stage's name),
5 `check` found that a result is wrong.
Errors are one line on standard error: "minksum: FILE:LINE:COLUMN: what", or
"minksum: FILE: polygon K, ring R, vertex V: what"; all of these count from 1,
and ring 1 is the outer one.)";

int run(int argc, char** argv, ProcessLimits& limits) {
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  const bool asks_for_one = !words.empty() && !words[0].starts_with('-') && words[0] != "help";
  CommandLine line("Exact Minkowski sums in the plane", "minksum", asks_for_one ? words[0] : "");
  line.add_version("minksum " MINKSUM_VERSION);
  Program program{line, limits, {}, {}};
  for (const auto add : kSubcommands) add(program);
  line.add_footer(kFooter);
  try {
    if (const auto asked = line.parse(words)) {
      write_standard_output([&](std::ostream& out) { out << *asked; });
      return kFine;
    }
    apply(limits);
    return program.run_of.at(line.chosen())();
  } catch (const Failure& failure) {
    if (failure.code() != kWrongUsage) throw;
    const std::string command = line.chosen().empty() ? "" : " " + line.chosen();
    throw Failure(kWrongUsage, failure.what() + (" (minksum" + command + " --help)"));
  }
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

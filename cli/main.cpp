// The program: arguments in, exit code out. Each subcommand has a file of its own.
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "commands/batch.hpp"
#include "commands/commands.hpp"
#include "commands/cspace.hpp"
#include "commands/draw.hpp"
#include "commands/offset.hpp"
#include "commands/reach.hpp"
#include "minksum/version.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "options/uses_options.hpp"
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

Command add_info(CommandLine& line, InfoArguments& arguments, ProcessLimits& limits) {
  const Command info =
      line.add_command("info", "What a geometry is: parts, holes, box, exact area, validity, bits");
  info.footer("\nExit code 2 if polygons are not valid as they stand; all faults are listed.\n");
  info.add_option("FILE", arguments.file, "The geometry, or - for standard input")
      .required()
      .type_name("FILE");
  info.add_flag("--json", arguments.json, "As JSON");
  add_fill_option(info, arguments.resolve.fill);
  info.add_flag("--regularize", arguments.resolve.regularize, "Drop polylines, points and spikes");
  add_limit_options(info, limits, false);
  return info;
}

Command add_check(CommandLine& line, CheckArguments& arguments, ProcessLimits& limits) {
  const Command check = line.add_command(
      "check", "Whether a result, of minksum or of any program, is the sum of two geometries");
  check.footer(
      "\nDecided by other methods than `sum` uses: validity; points near edges, in holes and at\n"
      "random; and, where it is small enough for the second method, the whole sum exactly.\n"
      "Rounded results need --within. Exit code 5 if an error is found.\n");
  const auto add_file = [check](const char* name, std::string& file, const char* what) {
    check.add_option(name, file, what).required().type_name("FILE");
  };
  add_file("RESULT", arguments.result, "What is said to be the sum");
  add_file("P", arguments.operands[0], "The first operand");
  add_file("Q", arguments.operands[1], "The second operand");
  add_fill_option(check, arguments.options.fill);
  check.add_flag("--regularize", arguments.options.regularize,
                 "Drop operands' polylines, points and spikes");
  check
      .add_option(
          "--within",
          [&arguments](const std::string& text) {
            arguments.options.within = parse_number("--within", text);
            if (arguments.options.within.sign() < 0) {
              throw Failure(kWrongUsage, "--within takes a number that is not negative");
            }
          },
          "How far, in x and in y, the result may be off; 0, the default: not at all")
      .type_name("D");
  check
      .add_option("--samples", arguments.options.samples,
                  "Random points, beside those near edges; 1000 without it")
      .type_name("N");
  check
      .add_option("--edges", arguments.options.edges,
                  "Edges of the result near which points are tested; 10000 without it")
      .type_name("N");
  check.add_option("--seed", arguments.options.seed, "Seed of the random points").type_name("N");
  check
      .add_option("--proof-segments", arguments.options.limits.max_segments,
                  "Largest signed convolution for which the whole sum is compared")
      .type_name("N");
  check.add_flag("--json", arguments.json, "As JSON");
  add_limit_options(check, limits, false);
  return check;
}

// All subcommands' arguments; `run` is that of the one that was chosen.
struct Commands {
  Commands(CommandLine& line, ProcessLimits& limits);

  void add(const Command& command, std::function<int()> run) {
    run_of[command.name()] = std::move(run);
  }
  /// A subcommand that computes sums, with what is typed in two parts.
  template <class Arguments, class Typed>
  void add(const Command& command, Arguments& arguments, const Typed& typed,
           const ProcessLimits& limits, int (*run)(const Arguments&)) {
    add(command, [&arguments, &typed, &limits, run] {
      arguments.limits = limits.read;
      arguments.options.limits = limits.sum;
      settle(arguments, typed);
      return run(arguments);
    });
  }
  void add_sums(CommandLine& line, ProcessLimits& limits);
  void add_uses(CommandLine& line, ProcessLimits& limits);
  void add_robots(CommandLine& line, ProcessLimits& limits);

  SumArguments sum;
  TypedSum typed_sum;
  InfoArguments info;
  CheckArguments check;
  MorphologyArguments morphology;
  TypedMorphology typed_morphology;
  NestingArguments nesting;
  TypedNesting typed_nesting;
  OffsetArguments offset;
  TypedOffset typed_offset;
  DepthArguments depth;
  TypedDepth typed_depth;
  CspaceArguments cspace;
  TypedCspace typed_cspace;
  ReachArguments reach;
  TypedReach typed_reach;
  DrawArguments draw;
  BatchArguments batch;
  TypedBatch typed_batch;
  std::map<std::string, std::function<int()>> run_of;
};

Commands::Commands(CommandLine& line, ProcessLimits& limits) {
  add_sums(line, limits);
  add_uses(line, limits);
  add_robots(line, limits);
  add(add_draw(line, draw, limits), [this, &limits] {
    draw.limits = limits.read;
    settle(draw);
    return run_draw(draw);
  });
  add(add_batch(line, batch, typed_batch, limits), [this, &limits] {
    batch.limits = limits;
    settle(batch, typed_batch);
    return run_batch(batch);
  });
}

void Commands::add_sums(CommandLine& line, ProcessLimits& limits) {
  add(add_sum(line, sum, typed_sum, limits), sum, typed_sum, limits, run_sum);
  add(add_info(line, info, limits), [this, &limits] {
    info.limits = limits.read;
    return run_info(info);
  });
  add(add_check(line, check, limits), [this, &limits] {
    check.limits = limits.read;
    return run_check(check);
  });
}

void Commands::add_uses(CommandLine& line, ProcessLimits& limits) {
  using enum MorphologyArguments::Operation;
  for (const auto operation : {kDilate, kErode, kOpen, kClose}) {
    add(add_morphology(line, operation, morphology, typed_morphology, limits),
        [this, operation, &limits] {
          morphology.operation = operation;
          morphology.limits = limits.read;
          morphology.options.limits = limits.sum;
          settle(morphology, typed_morphology);
          return run_morphology(morphology);
        });
  }
  for (const bool inner_fit : {false, true}) {
    add(add_nesting(line, inner_fit, nesting, typed_nesting, limits), [this, inner_fit, &limits] {
      nesting.inner_fit = inner_fit;
      nesting.limits = limits.read;
      nesting.options.limits = limits.sum;
      settle(nesting, typed_nesting);
      return run_nesting(nesting);
    });
  }
  add(add_offset(line, offset, typed_offset, limits), offset, typed_offset, limits, run_offset);
  add(add_depth(line, depth, typed_depth, limits), depth, typed_depth, limits, run_depth);
}

void Commands::add_robots(CommandLine& line, ProcessLimits& limits) {
  add(add_cspace(line, cspace, typed_cspace, limits), cspace, typed_cspace, limits, run_cspace);
  add(add_reach(line, reach, typed_reach, limits), reach, typed_reach, limits, run_reach);
}

int run(int argc, char** argv, ProcessLimits& limits) {
  CommandLine line("Exact Minkowski sums in the plane", "minksum");
  line.add_version("minksum " MINKSUM_VERSION);
  const Commands commands(line, limits);
  line.add_footer(kFooter);
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  if (const auto asked = line.parse(words, " (minksum --help)")) {
    write_standard_output([&](std::ostream& out) { out << *asked; });
    return kFine;
  }
  apply(limits);
  return commands.run_of.at(line.chosen())();
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

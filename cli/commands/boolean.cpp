// minksum union, intersection, difference and symdiff: combine two sets.
#include "minksum/boolean.hpp"

#include <iterator>

#include "commands/operations.hpp"
#include "commands/subcommands.hpp"
#include "minksum/resolve.hpp"
#include "options/operation_options.hpp"
#include "options/result_options.hpp"
#include "options/sum_options.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

struct Words {
  const char* name;
  const char* what;
  const char* result;
  const char* title;
};

/// By Operation.
constexpr Words kWords[] = {
    {"union", "Union: what lies in A or in B", "union", "A ∪ B"},
    {"intersection", "Intersection: the areas in both A and B", "intersection", "A ∩ B"},
    {"difference", "Difference: the areas in A but not in B", "difference", "A \\ B"},
    {"symdiff", "Symmetric difference: the areas in one of A and B alone", "symmetric difference",
     "A △ B"}};

const Words& words_of(const BooleanArguments& arguments) {
  return kWords[static_cast<std::size_t>(arguments.operation)];
}

void draw_combination(const BooleanArguments& arguments, const Geometry& a, const Geometry& b,
                      const Geometry& result, OutputFiles& files) {
  const Options reading{.fill = arguments.options.fill};
  const char* const title = words_of(arguments).title;
  const Captions captions{title, "A", "B", title};
  write_picture(files, arguments.picture,
                {resolve(a, reading), resolve(b, reading), result, nullptr, captions, true});
}

int run_boolean(const BooleanArguments& arguments) {
  return run_operation(arguments, combined, draw_combination);
}

}  // namespace

Geometry combined(const BooleanArguments& arguments, const Geometry& a, const Geometry& b) {
  using enum BooleanArguments::Operation;
  const Geometry sets[] = {resolve(a, arguments.options, 0), resolve(b, arguments.options, 1)};
  Options part = arguments.options;
  part.fill = FillRule::kAutomatic;
  if (arguments.operation == kUnion) return unite(sets, part);
  for (int i = 0; i < 2; ++i) {
    if (!sets[i].has_thin_parts()) continue;
    Culprit culprit;
    culprit.operand = i;
    throw Error(ErrorCode::kBadInput,
                "polylines, points and spikes can only be united (--regularize drops them)",
                culprit);
  }
  constexpr decltype(&intersect) kOperations[] = {intersect, subtract, symmetric_difference};
  const auto index = static_cast<std::size_t>(arguments.operation) - 1;
  return kOperations[index](sets[0].region, sets[1].region, part);
}

Command describe_boolean(CommandLine& line, BooleanArguments& arguments, ProcessLimits& limits) {
  const Words& words = words_of(arguments);
  const Command command = line.add_command(words.name, words.what);
  command.footer("\nFiles as for `minksum sum`; one of them may be \"-\" for standard input.\n");
  add_operand(command, "A", arguments.operands[0], "The first set");
  add_operand(command, "B", arguments.operands[1], "The second set");
  add_result_options(command, arguments, words.result);
  add_fill_option(command, arguments.options.fill);
  add_regularize_option(command, arguments.options.regularize);
  add_picture_option(command, arguments.picture, "Draw A, B and the result");
  add_stats_option(command, arguments.stats);
  add_each_options(command, arguments, {"--svg"});
  add_limit_options(command, limits, true);
  return command;
}

void convert(BooleanArguments& arguments) {
  require_one_standard_input(arguments.operands, "A and B");
  convert_operation(arguments, arguments);
}

void add_boolean(Program& program) {
  using enum BooleanArguments::Operation;
  for (const auto operation : {kUnion, kIntersection, kDifference, kSymmetricDifference}) {
    BooleanArguments arguments;
    arguments.operation = operation;
    program.add(describe_boolean, run_boolean, arguments);
  }
}

}  // namespace minksum::cli

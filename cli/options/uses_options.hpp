// The options of the subcommands for what sums are used for: morphology, nesting, depth.
#pragma once

#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

struct TypedMorphology : TypedResult {};

/// Options as they are typed; turned into NestingArguments when all of them are known.
struct TypedNesting : TypedResult {
  std::string reference;
  std::vector<std::string> placements;
};

struct TypedDepth {
  std::string along;
};

/// Each adds a subcommand by this name; parsing fills the other three.
Command add_morphology(CommandLine& line, MorphologyArguments::Operation operation,
                       MorphologyArguments& arguments, TypedMorphology& typed,
                       ProcessLimits& limits);
Command add_nesting(CommandLine& line, bool inner_fit, NestingArguments& arguments,
                    TypedNesting& typed, ProcessLimits& limits);
Command add_depth(CommandLine& line, DepthArguments& arguments, TypedDepth& typed,
                  ProcessLimits& limits);

/// What no option can see by itself. Throws a Failure for wrong usage.
void settle(MorphologyArguments& arguments, const TypedMorphology& typed);
void settle(NestingArguments& arguments, const TypedNesting& typed);
void settle(DepthArguments& arguments, const TypedDepth& typed);

}  // namespace minksum::cli

// Declares the options of the subcommands for uses of sums: morphology, nesting and depth.
#pragma once

#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

struct MorphologyText : ResultText {};

/// Options as they are typed; `convert` turns them into NoFitArguments.
struct NoFitText : ResultText {
  std::string reference;
  std::vector<std::string> placements;
};

struct DepthText {
  std::string along;
};

/// Each function adds a subcommand; parsing fills its last three arguments.
Command add_morphology(CommandLine& line, MorphologyArguments::Operation operation,
                       MorphologyArguments& arguments, MorphologyText& typed,
                       ProcessLimits& limits);
Command add_no_fit(CommandLine& line, bool inner_fit, NoFitArguments& arguments, NoFitText& typed,
                   ProcessLimits& limits);
Command add_depth(CommandLine& line, DepthArguments& arguments, DepthText& typed,
                  ProcessLimits& limits);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(MorphologyArguments& arguments, const MorphologyText& typed);
void convert(NoFitArguments& arguments, const NoFitText& typed);
void convert(DepthArguments& arguments, const DepthText& typed);

}  // namespace minksum::cli

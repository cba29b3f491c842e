// Declares the options of `minksum sum`, and --fill for all subcommands.
#pragma once

#include "commands/commands.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

/// Options as they are typed; `convert` turns them into SumArguments.
struct SumText : ResultText {
  bool no_cover = false;
  bool no_filter = false;
};

/// Adds the subcommand; parsing fills the other three arguments.
Command add_sum(CommandLine& line, SumArguments& arguments, SumText& typed, ProcessLimits& limits);

/// Adds --fill to any subcommand.
Option add_fill_option(const Command& command, FillRule& fill);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(SumArguments& arguments, const SumText& typed);

}  // namespace minksum::cli

// Declares the options of `minksum sum`, and --fill for all subcommands.
#pragma once

#include "commands/commands.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

/// Adds the subcommand; parsing fills the other two arguments.
Command describe_sum(CommandLine& line, SumArguments& arguments, ProcessLimits& limits);

/// Adds --regularize.
Option add_regularize_option(const Command& command, bool& regularize);
/// Adds --fill to any subcommand.
Option add_fill_option(const Command& command, FillRule& fill);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(SumArguments& arguments);

}  // namespace minksum::cli

// Declares the options of the subcommands for uses of sums: morphology, nesting, offsets
// and depth.
#pragma once

#include <string>

#include "commands/commands.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

/// Adds --svg, which draws what `what` says.
void add_picture_option(const Command& command, std::string& picture, const char* what);

/// Adds --stats for an operation.
void add_stats_option(const Command& command, std::string& stats);

/// Throws a Failure if both operands are standard input.
void require_one_standard_input(const std::string (&operands)[2], const std::string& names);
/// Converts and checks what all operations whose result is a geometry share. Both arguments are
/// parts of the same. Throws a Failure for wrong usage.
void convert_operation(ResultArguments& result, const OperandArguments& operands);

/// Each function adds the subcommand that its arguments name; parsing fills the arguments.
Command describe_morphology(CommandLine& line, MorphologyArguments& arguments,
                            ProcessLimits& limits);
Command describe_boolean(CommandLine& line, BooleanArguments& arguments, ProcessLimits& limits);
Command describe_transform(CommandLine& line, TransformArguments& arguments, ProcessLimits& limits);
Command describe_no_fit(CommandLine& line, NoFitArguments& arguments, ProcessLimits& limits);
Command describe_offset(CommandLine& line, OffsetArguments& arguments, ProcessLimits& limits);
Command describe_depth(CommandLine& line, DepthArguments& arguments, ProcessLimits& limits);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(MorphologyArguments& arguments);
void convert(BooleanArguments& arguments);
void convert(TransformArguments& arguments);
void convert(NoFitArguments& arguments);
void convert(OffsetArguments& arguments);
void convert(DepthArguments& arguments);

}  // namespace minksum::cli

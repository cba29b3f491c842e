// Declares `minksum offset` and its options.
#pragma once

#include <string>

#include "commands/commands.hpp"
#include "minksum/offset.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

/// `minksum offset A --distance D ...`
struct OffsetArguments : ResultArguments {
  std::string operand;  ///< file name; "-" = standard input
  Rational distance;
  std::string picture;  ///< empty = none
  io::ReadLimits limits;
  OffsetOptions shape;
  Options options;
};

/// Options as they are typed; `convert` turns them into OffsetArguments.
struct OffsetText : ResultText {
  std::string distance;
  std::string join;
  std::string cap;
  std::string miter_limit;
  std::string tolerance;
  std::string side;
};

/// Adds the subcommand; parsing fills the other three arguments.
Command add_offset(CommandLine& line, OffsetArguments& arguments, OffsetText& typed,
                   ProcessLimits& limits);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(OffsetArguments& arguments, const OffsetText& typed);

/// Runs `minksum offset`. Returns an exit code, or throws what `report_failure` (failure.hpp)
/// names.
int run_offset(const OffsetArguments& arguments);

}  // namespace minksum::cli

// Declares `minksum draw` and its options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "minksum/resolve.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "pictures/figure.hpp"

namespace minksum::cli {

/// `minksum draw FILE...`
struct DrawArguments : FigureLook {
  std::vector<std::string> files;   ///< "-" = standard input
  std::string output;               ///< empty = standard output
  std::vector<std::string> styles;  ///< one for each file; empty = chosen by position
  std::vector<std::string> captions;
  bool faults = false;  ///< draw rings as they stand, with their faults
  bool labels = false;  ///< number the vertices
  FillRule fill = FillRule::kAutomatic;
  io::ReadLimits limits;
};

/// Adds the subcommand; parsing fills the other two arguments.
Command add_draw(CommandLine& line, DrawArguments& arguments, ProcessLimits& limits);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(DrawArguments& arguments);

/// Runs `minksum draw`. Returns an exit code, or throws what `report_failure` (failure.hpp) names.
int run_draw(const DrawArguments& arguments);

}  // namespace minksum::cli

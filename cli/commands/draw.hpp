// The options of `minksum draw`.
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
struct DrawArguments {
  std::vector<std::string> files;   ///< "-" = standard input
  std::string output;               ///< empty = standard output
  std::vector<std::string> styles;  ///< one a file, or none: by position
  std::vector<std::string> captions;
  std::string title;
  double width = 960;
  Theme theme = Theme::kAuto;
  bool axes = true;
  bool legend = true;
  bool faults = false;  ///< draws rings as they stand, with their faults
  bool labels = false;  ///< numbers vertices
  FillRule fill = FillRule::kAutomatic;
  io::ReadLimits limits;
};

/// Adds the subcommand; parsing fills the other two.
Command add_draw(CommandLine& line, DrawArguments& arguments, ProcessLimits& limits);

/// What no option can see by itself. Throws a Failure for wrong usage.
void convert(DrawArguments& arguments);

/// Returns an exit code, and throws what `report_failure` (failure.hpp) can name.
int run_draw(const DrawArguments& arguments);

}  // namespace minksum::cli

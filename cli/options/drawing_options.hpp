// Declares the options that say how operands that are drawings are read.
#pragma once

#include "minksum/io.hpp"
#include "options/command_line.hpp"

namespace minksum::cli {

/// Adds --layer and --join-ends and, unless the subcommand has options of these names already,
/// --tolerance and --side.
void add_drawing_options(const Command& command, io::DrawingOptions& drawing, bool has_tolerance);

}  // namespace minksum::cli

// Declares the options that every subcommand has, or every subcommand that computes sums.
#pragma once

#include "options/command_line.hpp"
#include "process/telling.hpp"

namespace minksum::cli {

/// Adds --quiet, --progress, and --verbose unless the subcommand has its own.
void add_telling_options(const Command& command, Telling& telling);

/// Adds --threads if the subcommand computes sums, which threads share, and has no --threads yet.
/// Sets `threads` to all cores.
void add_threads_option(const Command& command, int& threads);

}  // namespace minksum::cli

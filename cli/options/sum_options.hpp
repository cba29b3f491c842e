// The options of `minksum sum`.
#pragma once

#include <CLI/CLI.hpp>

#include "commands/commands.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"

namespace minksum::cli {

/// Options as they are typed; turned into SumArguments when all of them are known.
struct TypedSum : TypedResult {
  bool no_cover = false;
  bool no_filter = false;
};

/// Adds the subcommand; parsing fills the other three.
CLI::App* add_sum(CLI::App& app, SumArguments& arguments, TypedSum& typed, ProcessLimits& limits);

/// Adds --fill, for any subcommand.
CLI::Option* add_fill_option(CLI::App& command, FillRule& fill);

/// What no option can see by itself. Throws a Failure for wrong usage.
void settle(SumArguments& arguments, const TypedSum& typed);

}  // namespace minksum::cli

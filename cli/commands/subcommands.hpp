// Lists the subcommands. To add one, write its file, name it in CMakeLists.txt and put its function
// into both lists below: see CONTRIBUTING.md.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "options/command_line.hpp"
#include "options/limits.hpp"

namespace minksum::cli {

/// Holds what the subcommands see of the program.
struct Program {
  CommandLine& line;
  ProcessLimits& limits;
  std::map<std::string, std::function<int()>> run_of;  ///< by the subcommand's name

  /// Registers `run`, which is called after parsing if this subcommand was chosen. It returns the
  /// exit code.
  void add(const Command& command, std::function<int()> run) {
    run_of[command.name()] = std::move(run);
  }
  /// Adds a subcommand that computes sums, by the function that describes its options.
  template <class Arguments, class Typed>
  void add(Command (*describe)(CommandLine&, Arguments&, Typed&, ProcessLimits&),
           int (*run)(const Arguments&)) {
    const auto arguments = std::make_shared<Arguments>();
    const auto typed = std::make_shared<Typed>();
    add(describe(line, *arguments, *typed, limits), arguments, typed, run);
  }
  /// Adds a subcommand that computes sums. Before it runs, its limits are set and `convert` is
  /// called.
  template <class Arguments, class Typed>
  void add(const Command& command, const std::shared_ptr<Arguments>& arguments,
           const std::shared_ptr<Typed>& typed, int (*run)(const Arguments&)) {
    add(command, [this, arguments, typed, run] {
      arguments->limits = limits.read;
      arguments->options.limits = limits.sum;
      convert(*arguments, *typed);
      return run(*arguments);
    });
  }
};

// Each function adds one subcommand, or several that share their options.
void add_sum(Program& program);
void add_info(Program& program);
void add_check(Program& program);
void add_morphology(Program& program);
void add_no_fit(Program& program);
void add_offset(Program& program);
void add_depth(Program& program);
void add_cspace(Program& program);
void add_reach(Program& program);
void add_draw(Program& program);
void add_batch(Program& program);

/// All of these functions, in the order in which `--help` shows the subcommands.
inline constexpr void (*kSubcommands[])(Program&) = {
    add_sum,   add_info,   add_check, add_morphology, add_no_fit, add_offset,
    add_depth, add_cspace, add_reach, add_draw,       add_batch};

}  // namespace minksum::cli

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
#include "options/shared_options.hpp"
#include "options/unused_options.hpp"
#include "process/progress.hpp"
#include "process/telling.hpp"

namespace minksum::cli {

/// Sets the limits that the arguments have: all, or those on operands; and on sums, for options.
void set_limits(auto& arguments, const ProcessLimits& limits) {
  if constexpr (requires { arguments.limits = limits; }) {
    arguments.limits = limits;
  } else {
    arguments.limits = limits.read;
  }
  if constexpr (requires { arguments.options; }) arguments.options.limits = limits.sum;
}

/// Holds what the subcommands see of the program.
struct Program {
  CommandLine& line;
  ProcessLimits& limits;
  Telling telling;
  std::map<std::string, std::function<int()>> run_of;  ///< by the subcommand's name

  /// Registers `run`, which is called after parsing if this subcommand was chosen. It returns the
  /// exit code.
  void add(const Command& command, std::function<int()> run) {
    run_of[command.name()] = std::move(run);
  }
  /// Adds a subcommand by the function that describes its options, and the options that all
  /// subcommands share. Before it runs, its limits are set, and its arguments are converted and
  /// checked by `convert`, which each subcommand declares for them.
  template <class Arguments>
  void add(Command (*describe)(CommandLine&, Arguments&, ProcessLimits&),
           int (*run)(const Arguments&), Arguments defaults = {}) {
    const auto arguments = std::make_shared<Arguments>(std::move(defaults));
    const Command command = describe(line, *arguments, limits);
    if constexpr (requires { arguments->options; }) {
      add_threads_option(command, arguments->options.threads);
    }
    add_telling_options(command, telling);
    add(command, [this, arguments, run] {
      set_limits(*arguments, limits);
      set_telling(telling);
      const auto progress = live_progress();
      if constexpr (requires { arguments->options; }) arguments->options.progress = progress;
      if constexpr (requires { arguments->progress; }) arguments->progress = progress;
      if constexpr (requires { arguments->settings; }) arguments->settings = settings();
      convert(*arguments);
      const int code = run(*arguments);
      StatusLine::remove();
      if constexpr (requires { arguments->limits; }) note_unused(limits.read);
      tell_cost();
      return code;
    });
  }
  /// Returns the options that results depend on.
  [[nodiscard]] std::string settings() const {
    return line.given({"-o", "--format", "--stats", "--threads", "--restart", "--timeout",
                       "--max-memory", "-v", "-q", "--progress"});
  }
};

// Each function adds one subcommand, or several that share their options.
void add_sum(Program& program);
void add_info(Program& program);
void add_check(Program& program);
void add_morphology(Program& program);
void add_no_fit(Program& program);
void add_offset(Program& program);
void add_boolean(Program& program);
void add_transform(Program& program);
void add_depth(Program& program);
void add_cspace(Program& program);
void add_reach(Program& program);
void add_draw(Program& program);
void add_batch(Program& program);
void add_help(Program& program);

/// All of these functions, in the order in which `--help` shows the subcommands.
inline constexpr void (*kSubcommands[])(Program&) = {
    add_sum,     add_info,      add_check,  add_morphology, add_no_fit, add_offset, add_depth,
    add_boolean, add_transform, add_cspace, add_reach,      add_draw,   add_batch,  add_help};

}  // namespace minksum::cli

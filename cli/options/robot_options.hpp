// Declares what the subcommands about robots share: their operands and how these are read.
#pragma once

#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "minksum/configuration_space.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"

namespace minksum::cli {

/// `minksum cspace ROBOT OBSTACLES ...` and `minksum reach ROBOT OBSTACLES ...`
struct RobotArguments : OperandArguments {
  std::string workspace;  ///< empty = none
};

void add_robot_options(const Command& command, RobotArguments& arguments,
                       ConfigurationOptions& setting);
/// Throws a Failure if several files are standard input.
void require_one_standard_input(const RobotArguments& arguments);

/// The largest number of slices; nobody would wait for more.
inline constexpr int kMostTurns = 1'000'000;
/// Returns a number of angles from 1 to kMostTurns. Throws a Failure.
[[nodiscard]] std::size_t parse_angles(const std::string& text);

/// Robot and obstacles; the workspace goes to the setting.
struct RobotScene {
  Geometry robot;
  Geometry obstacles;
};
[[nodiscard]] RobotScene read_scene(const RobotArguments& arguments, ConfigurationOptions& setting);

/// Does the same as `fail_about`, also for errors about the workspace.
[[noreturn]] void fail_about_scene(const Error& error, const RobotArguments& arguments);

}  // namespace minksum::cli

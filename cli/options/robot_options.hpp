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
struct RobotArguments {
  std::string operands[2];
  std::string workspace;  ///< empty = none
  io::ReadLimits limits;
};

/// Options as they are typed; `convert_robot` turns them into ConfigurationOptions.
struct RobotText {
  std::string reference;
};

void add_robot_options(const Command& command, RobotArguments& arguments, RobotText& typed,
                       Options& options);
/// Fills `options`. Throws a Failure for wrong usage.
void convert_robot(const RobotArguments& arguments, const RobotText& typed,
                   ConfigurationOptions& setting);

/// The largest number of slices; nobody would wait for more.
inline constexpr int kMostTurns = 1'000'000;
/// Returns a number of angles from 1 to kMostTurns. Throws a Failure.
[[nodiscard]] std::size_t parse_angles(const std::string& text);

/// Robot and obstacles; the workspace goes to the setting.
struct RobotScene {
  Geometry robot;
  Geometry obstacles;
};
[[nodiscard]] RobotScene read_scene(const RobotArguments& arguments, FillRule fill,
                                    ConfigurationOptions& setting);

/// Does the same as `fail_about`, also for errors about the workspace.
[[noreturn]] void fail_about_scene(const Error& error, const RobotArguments& arguments);

}  // namespace minksum::cli

// Declares `minksum reach`, which tells whether and how a robot gets from one configuration to
// another.
#pragma once

#include "minksum/reach.hpp"
#include "options/robot_options.hpp"

namespace minksum::cli {

/// `minksum reach ROBOT OBSTACLES ...`
struct ReachArguments : RobotArguments {
  Configuration from;
  Configuration to;
  bool json = false;
  std::string output;   ///< for the path as GeoJSON; empty = none
  std::string picture;  ///< empty = none
  ReachOptions setting;
  Options options{.threads = 0};
};

struct ReachText : RobotText {
  std::string from;
  std::string to;
  std::string angles;
};

Command add_reach(CommandLine& line, ReachArguments& arguments, ReachText& typed,
                  ProcessLimits& limits);
/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(ReachArguments& arguments, const ReachText& typed);
int run_reach(const ReachArguments& arguments);

/// Draws the scene and, if a path exists, the robot along it.
[[nodiscard]] std::string reach_picture(const ReachArguments& arguments,
                                        const ReachOptions& setting, const RobotScene& scene,
                                        const Reach& found);

}  // namespace minksum::cli

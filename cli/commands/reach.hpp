// minksum reach: whether a robot gets from one configuration to another, and how.
#pragma once

#include "minksum/reach.hpp"
#include "options/robot_options.hpp"

namespace minksum::cli {

/// `minksum reach ROBOT OBSTACLES ...`
struct ReachArguments : RobotArguments {
  Configuration from;
  Configuration to;
  bool json = false;
  std::string output;   ///< of the path as GeoJSON; empty = none
  std::string picture;  ///< empty = none
  ReachOptions options;
};

struct ReachText : RobotText {
  std::string from;
  std::string to;
  std::string angles;
};

Command add_reach(CommandLine& line, ReachArguments& arguments, ReachText& typed,
                  ProcessLimits& limits);
/// What no option can see by itself. Throws a Failure for wrong usage.
void convert(ReachArguments& arguments, const ReachText& typed);
int run_reach(const ReachArguments& arguments);

/// The scene, and the robot on its way, if there is one.
[[nodiscard]] std::string reach_picture(const ReachArguments& arguments,
                                        const ReachOptions& options, const RobotScene& scene,
                                        const Reach& found);

}  // namespace minksum::cli

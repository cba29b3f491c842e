// Declares the arguments and the picture of `minksum reach`.
#pragma once

#include "minksum/reach.hpp"
#include "options/robot_options.hpp"

namespace minksum::cli {

/// `minksum reach ROBOT OBSTACLES ...`
struct ReachArguments : RobotArguments {
  Configuration from;
  Configuration to;
  bool json = false;
  std::string output;  ///< for the path as GeoJSON; empty = none
  ReachOptions setting;
};

/// Checks what no option can check alone. Throws a Failure for wrong usage.
void convert(const ReachArguments& arguments);

/// Draws the scene and, if a path exists, the robot along it.
[[nodiscard]] std::string reach_picture(const ReachArguments& arguments,
                                        const ReachOptions& setting, const RobotScene& scene,
                                        const Reach& found);

}  // namespace minksum::cli

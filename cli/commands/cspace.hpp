// Declares `minksum cspace`, which computes the configuration-space obstacles and the free space
// of a robot that moves and turns.
#pragma once

#include "options/result_options.hpp"
#include "options/robot_options.hpp"

namespace minksum::cli {

/// `minksum cspace ROBOT OBSTACLES ...`
struct CspaceArguments : RobotArguments {
  ResultArguments result;
  std::vector<Turn> turns;
  bool free = false;
  std::string picture;  ///< empty = none
  std::string slices;   ///< a folder; empty = none
  std::string stats;    ///< empty = none
  bool tight = false;
  ConfigurationOptions setting;
  Options options{.threads = 0};
};

struct CspaceText : RobotText {
  ResultText result;
  std::string angles;
  std::string theta;
  double tolerance = 1e-3;
};

Command add_cspace(CommandLine& line, CspaceArguments& arguments, CspaceText& typed,
                   ProcessLimits& limits);
/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(CspaceArguments& arguments, const CspaceText& typed);
int run_cspace(const CspaceArguments& arguments);

}  // namespace minksum::cli

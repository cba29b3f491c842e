// Declares `minksum batch` and its options.
#pragma once

#include <string>
#include <vector>

#include "batch/named_operations.hpp"
#include "options/command_line.hpp"
#include "options/limits.hpp"
#include "options/result_options.hpp"
#include "output/output_file.hpp"

namespace minksum::cli {

/// `minksum batch JOBS` and `minksum batch --pairs DIR`
struct BatchArguments : ResultArguments {
  std::string jobs;               ///< "-" = standard input
  std::string pairs;              ///< a folder, instead of jobs
  std::string operation = "nfp";  ///< what --pairs computes
  int rotations = 1;
  bool tight = false;  ///< pairs: with tight places
  int threads = 0;     ///< 0 = as many as the machine has
  bool restart = false;
  bool no_output = false;  ///< pairs: compute only
  std::string stats;       ///< empty = none
  FillRule fill = FillRule::kAutomatic;
  std::vector<OptionText> defaults;  ///< options of jobs that do not set them
  double seconds = 0;                ///< for each job; 0 = no limit
  ProcessLimits limits;              ///< its seconds are `seconds`
};

/// Adds the subcommand; parsing fills the other two arguments. The time limit is one for each job,
/// not for the process.
Command describe_batch(CommandLine& line, BatchArguments& arguments, ProcessLimits& limits);

/// Converts and checks what no option can check alone. Throws a Failure for wrong usage.
void convert(BatchArguments& arguments);

/// Registers the output files. Throws a Failure if two of them, or one and JOBS, are the same file.
void expect_files(const BatchArguments& arguments, OutputFiles& files);

/// Runs `minksum batch`. Returns an exit code, or throws what `report_failure` (failure.hpp) names.
int run_batch(const BatchArguments& arguments);
/// Runs `minksum batch --pairs` in the same way.
int run_pairs(const BatchArguments& arguments);

}  // namespace minksum::cli

// The options of `minksum batch`.
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
  std::string operation = "nfp";  ///< of pairs
  int rotations = 1;
  bool tight = false;  ///< pairs: with tight places
  int threads = 0;     ///< 0 = as many as the machine has
  bool restart = false;
  bool no_output = false;  ///< pairs: compute only
  std::string stats;       ///< empty = none
  FillRule fill = FillRule::kAutomatic;
  std::vector<OptionText> defaults;   ///< for jobs
  ProcessLimits limits;               ///< seconds are those of a job
};

/// These options as they are typed.
struct BatchText : ResultText {
  double seconds = 0;
};

/// Adds the subcommand; parsing fills the other three. The limit on time is not the process's.
Command add_batch(CommandLine& line, BatchArguments& arguments, BatchText& typed,
                  ProcessLimits& limits);

/// What no option can see by itself. Throws a Failure for wrong usage.
void convert(BatchArguments& arguments, const BatchText& typed);

/// Takes note of the outputs, of which none may be another, nor JOBS. Throws a Failure.
void expect_files(const BatchArguments& arguments, OutputFiles& files);

/// Returns an exit code, and throws what `report_failure` (failure.hpp) can name.
int run_batch(const BatchArguments& arguments);
/// The same for pairs.
int run_pairs(const BatchArguments& arguments);

}  // namespace minksum::cli

// The subcommands, and what their arguments say.
#pragma once

#include <string>

#include "minksum/check.hpp"
#include "minksum/io.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "minksum/round.hpp"

namespace minksum::cli {

/// What the program returns to its caller; `docs/cli.md` and `--help` say the same.
enum ExitCode : int {
  kFine = 0,
  kWrongUsage = 1,
  kBadInput = 2,       ///< also: an output that cannot be written
  kLimitExceeded = 3,  ///< a stated limit, or memory
  kInternal = 4,
  kWrongResult = 5,    ///< `minksum check` found an error
};

/// Where and how a result is written.
struct ResultArguments {
  std::string output;  ///< empty = standard output
  io::Format format = io::Format::kWkt;
  io::Coordinates coordinates;
  RoundingSide rounding = RoundingSide::kNearest;  ///< but for exact coordinates
};

/// `minksum sum P Q ...`
struct SumArguments : ResultArguments {
  std::string operands[2];       ///< file names; "-" = standard input
  bool keep_properties = false;  ///< write a Feature with those of P
  std::string tight;             ///< empty = none
  io::Format tight_format = io::Format::kWkt;
  std::string stats;    ///< empty = none
  std::string picture;  ///< empty = none
  std::string trace;    ///< a folder; empty = none
  int repeat = 1;
  bool verbose = false;
  io::ReadLimits limits;
  Options options;
};

/// `minksum info FILE`
struct InfoArguments {
  std::string file;
  bool json = false;
  io::ReadLimits limits;
  ResolveOptions resolve;
};

/// `minksum check RESULT P Q`
struct CheckArguments {
  std::string result;
  std::string operands[2];
  bool json = false;
  io::ReadLimits limits;
  CheckOptions options;
};

/// All return an exit code, and throw what `report_failure` (failure.hpp) can name.
int run_sum(const SumArguments& arguments);
int run_info(const InfoArguments& arguments);
int run_check(const CheckArguments& arguments);

}  // namespace minksum::cli

// Holds one run of `minksum sum`: operands, results and times.
#pragma once

#include <optional>
#include <string>

#include "minksum/geometry.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"

namespace minksum::cli {

/// Times of one run of the program. Those of the sum are medians over its repetitions.
struct Seconds {
  double read = 0;
  double sum = 0;
  double stages[kSumStages] = {};
  double round = 0;
  double write = 0;
};

struct SumRun {
  Geometry operands[2];
  std::optional<std::string> properties;  ///< those of P
  Geometry exact;
  std::optional<Geometry> tight;           ///< set if it was asked for
  std::optional<RoundingReport> rounding;  ///< none = exact coordinates are written
  Geometry rounded;
  Geometry rounded_tight;
  Statistics statistics;
  Seconds seconds;
};

}  // namespace minksum::cli

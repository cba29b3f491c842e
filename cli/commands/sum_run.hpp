// One run of `minksum sum`: what was read, what came of it, how long it took.
#pragma once

#include <optional>
#include <string>

#include "minksum/geometry.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/round.hpp"

namespace minksum::cli {

/// Times of one run of the program; those of the sum are medians over its repetitions.
struct Seconds {
  double read = 0;
  double sum = 0;
  double stages[kStageCount] = {};
  double round = 0;
  double write = 0;
};

struct SumRun {
  Geometry operands[2];
  std::optional<std::string> properties;  ///< of P
  Geometry exact;
  std::optional<Geometry> tight;           ///< if asked for
  std::optional<RoundingReport> rounding;  ///< none = exact coordinates are written
  Geometry rounded;
  Geometry rounded_tight;
  Statistics statistics;
  Seconds seconds;
};

}  // namespace minksum::cli

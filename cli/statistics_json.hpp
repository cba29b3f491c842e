// What `minksum sum --stats` says: docs/cli.md describes each key.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/region.hpp"

namespace minksum::cli {

/// Seconds outside the stages; `sum` is the median of all runs.
struct Seconds {
  double read = 0;
  double sum = 0;
  double write = 0;
  double stages[kStageCount] = {};  ///< medians, each by itself
};

/// The middle value; the mean of the two middle ones for an even number of them.
[[nodiscard]] double median(std::vector<double> values);

[[nodiscard]] const char* to_string(Method method);
[[nodiscard]] const char* to_string(Arithmetic arithmetic);

[[nodiscard]] nlohmann::ordered_json statistics_json(const SumArguments& arguments,
                                                     const Region (&operands)[2],
                                                     const Region& result,
                                                     const Statistics& statistics,
                                                     const Seconds& seconds);

/// Seconds that people can read: "1.2 ms".
[[nodiscard]] std::string readable_seconds(double seconds);

}  // namespace minksum::cli

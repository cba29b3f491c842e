// Makes the statistics of `minksum sum --stats`; docs/cli.md describes each key.
#pragma once

#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "commands/sum_run.hpp"
#include "output/json.hpp"

namespace minksum::cli {

/// Returns the middle value, or the mean of the two middle values.
[[nodiscard]] double median(std::vector<double> values);

[[nodiscard]] const char* to_string(Method method);
[[nodiscard]] const char* to_string(Arithmetic arithmetic);

[[nodiscard]] Json statistics_json(const SumArguments& arguments, const SumRun& run);

/// Times of one run of an operation on one or two operands.
struct OperationSeconds {
  double read = 0;
  double work = 0;  ///< computing and writing
};
[[nodiscard]] Json statistics_json(const OperandArguments& arguments, const Geometry (&operands)[2],
                                   const OperationSeconds& seconds);

/// Returns seconds for people to read, such as "1.2 ms".
[[nodiscard]] std::string readable_seconds(double seconds);

}  // namespace minksum::cli

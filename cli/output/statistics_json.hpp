// What `minksum sum --stats` says: docs/cli.md describes each key.
#pragma once

#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "commands/sum_run.hpp"
#include "output/json.hpp"

namespace minksum::cli {

/// The middle value; the mean of the two middle ones for an even number of them.
[[nodiscard]] double median(std::vector<double> values);

[[nodiscard]] const char* to_string(Method method);
[[nodiscard]] const char* to_string(Arithmetic arithmetic);

[[nodiscard]] Json statistics_json(const SumArguments& arguments, const SumRun& run);

/// Seconds that people can read: "1.2 ms".
[[nodiscard]] std::string readable_seconds(double seconds);

}  // namespace minksum::cli

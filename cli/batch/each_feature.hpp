// Applies an operation to the features of the first operand one by one: `--each`.
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "batch/in_order.hpp"
#include "commands/commands.hpp"
#include "output/json.hpp"

namespace minksum::cli {

/// What an operation answers for one feature: a geometry, rounded already, or JSON.
using FeatureAnswer = std::variant<Geometry, Json>;

/// The arguments of a command, as far as all commands with `--each` share them.
struct EachSettings {
  EachArguments each;
  std::string operands[2];  ///< the second is empty = there is only one
  std::string stats;
  io::ReadOptions limits;
  Options options;
  ResultArguments result;  ///< of what answers by geometries
  bool json = false;       ///< answers are JSON
  std::function<FeatureAnswer(const Geometry& a, const Geometry& b, Worker& worker)> answer;
};

/// Runs the operation on each feature and writes the answers in order, with properties, ids and the
/// reference system. Returns an exit code. Throws a Failure.
int run_each(const EachSettings& settings);

/// Does the same for the arguments of a command. `answer` gets them as one task needs them: one
/// thread, and no progress of its own.
template <class Arguments, class Answer>
int run_each(const Arguments& arguments, Answer answer) {
  using Result =
      std::invoke_result_t<Answer, const Arguments&, const Geometry&, const Geometry&, Worker&>;
  EachSettings settings;
  settings.each = arguments;
  for (int i = 0; i < 2; ++i) settings.operands[i] = arguments.operands[i];
  settings.stats = arguments.stats;
  settings.limits = arguments.limits;
  settings.options = arguments.options;
  settings.json = std::is_same_v<Result, Json>;
  Arguments mine = arguments;
  mine.options.threads = 1;
  mine.options.progress = {};
  if constexpr (std::is_base_of_v<ResultArguments, Arguments>) {
    settings.result = arguments;
    mine.progress = {};
  }
  settings.answer = [mine = std::move(mine), answer](const Geometry& a, const Geometry& b,
                                                     Worker& worker) -> FeatureAnswer {
    return answer(mine, a, b, worker);
  };
  return run_each(settings);
}

}  // namespace minksum::cli

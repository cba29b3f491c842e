// Operations on inputs that take them long, for tests of cancelling.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "minksum/cancel.hpp"

namespace minksum::test {

/// One operation on one input, with a token. `run` may be called many times.
struct CancelCase {
  std::string operation;
  std::string input;
  std::function<void(const std::optional<CancelToken>&)> run;
};

/// All operations on inputs of each kind that is hard for some phase: chains of holes that touch,
/// many triangles, combs, needles, nested squares, rows of squares, spirals, polylines and rings
/// that cross themselves, long numbers. `size` is about the number of vertices of an operand.
[[nodiscard]] std::vector<CancelCase> cancel_cases(int size);

}  // namespace minksum::test

// Lists operations with inputs that take them long, for tests of cancelling.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "minksum/options.hpp"

namespace minksum::test {

/// One operation on one input. `run` may be called many times; it looks at the options' token and
/// tells their progress callback.
struct CancelCase {
  std::string operation;
  std::string input;
  std::function<void(const Options&)> run;
};

/// Returns all operations on inputs of each kind that is hard for some phase. Kinds are chains of
/// holes that touch, many triangles, combs, needles, nested squares, rows of squares, and spirals.
/// Others are polylines and rings that cross themselves, and long numbers. `size` is about the
/// number of vertices of an operand.
[[nodiscard]] std::vector<CancelCase> cancel_cases(int size);

}  // namespace minksum::test

// Defines short names for the property tests.
#pragma once

#include <cstdint>
#include <string>

#include "minksum/minkowski_sum.hpp"
#include "minksum/testing.hpp"
#include "support/generators.hpp"
#include "support/shapes.hpp"

namespace minksum::test {

[[nodiscard]] inline Region sum_by(Method method, const Region& p, const Region& q) {
  SumSettings options;
  options.method = method;
  return minkowski_sum(p, q, options);
}

/// Returns the sum by the stages, however small the operands are.
[[nodiscard]] inline Region sum_by_stages(const Region& p, const Region& q) {
  SumSettings options;
  options.small = false;
  return minkowski_sum(p, q, options);
}

/// Returns what a failure prints: enough to run the case again.
[[nodiscard]] inline std::string note(std::uint64_t seed, const Region& p, const Region& q) {
  return "seed " + std::to_string(seed) + "\nP " + to_text(p) + "\nQ " + to_text(q);
}
[[nodiscard]] inline std::string note(std::uint64_t seed, const Pair& pair) {
  return pair.kind + ", " + note(seed, pair.p, pair.q);
}

}  // namespace minksum::test

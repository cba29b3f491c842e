// Random operands and pairs of operands, from a seed, without any data file.
#pragma once

#include <cstdint>
#include <string>

#include "minksum/region.hpp"
#include "support/random.hpp"

namespace minksum::test {

struct Pair {
  Region p;
  Region q;
  std::string kind;  ///< for messages
};

/// A small valid region of a random kind: 3 to about 16 vertices on a grid of up to 24, often a
/// very small one, so that collinear runs, parallel edges and coincidences are frequent.
[[nodiscard]] Region random_region(Random& random, std::string* kind = nullptr);
/// The same with one part only.
[[nodiscard]] Region random_polygon(Random& random, std::string* kind = nullptr);
/// Two random regions, or two that have to do with each other: equal, mirrored, a frame that the
/// other fits into with no slack or some; or one of them tiny. Now and then written in a scrambled
/// way.
[[nodiscard]] Pair random_pair(Random& random);

/// MINKSUM_SEED, or the default.
[[nodiscard]] std::uint64_t seed_from_environment(std::uint64_t default_seed);
/// MINKSUM_PAIRS, or the default.
[[nodiscard]] int count_from_environment(int default_count);

}  // namespace minksum::test

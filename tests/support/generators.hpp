// Makes random operands and pairs of operands from a seed, without any data file.
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

/// Returns a small valid region of a random kind, with 3 to about 16 vertices on a grid of up to
/// 24. Often the grid is very small, so that collinear runs, parallel edges and coincidences are
/// frequent.
[[nodiscard]] Region random_region(Random& random, std::string* kind = nullptr);
/// Returns such a region with one part only.
[[nodiscard]] Region random_polygon(Random& random, std::string* kind = nullptr);
/// Returns two random regions, one of which may be tiny, or two related regions. Related regions
/// are equal, mirrored, or a frame and a part that fits into it with or without play. Sometimes a
/// region is scrambled.
[[nodiscard]] Pair random_pair(Random& random);

/// Returns MINKSUM_SEED, or the default.
[[nodiscard]] std::uint64_t seed_from_environment(std::uint64_t default_seed);
/// Returns MINKSUM_PAIRS, or the default.
[[nodiscard]] int count_from_environment(int default_count);

}  // namespace minksum::test

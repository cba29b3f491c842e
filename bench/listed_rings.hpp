// Makes operands of the listing: clean rings of small integers.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "minksum/region.hpp"

namespace minksum::bench {

struct Site {
  std::int32_t x;
  std::int32_t y;
};

/// Rings one after the other, with the interior on the left, and without repeated or straight
/// vertices.
struct ListedRings {
  std::vector<Site> sites;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> previous;
};

struct ListedOperands {
  ListedRings p;
  ListedRings q;
  bool exact = false;  ///< on a common grid of integers; otherwise rounded
};

/// Returns operands with integers in [0, 2^30], so that sums fit 32 bits and cross products 64.
[[nodiscard]] ListedOperands listed_operands(const Region& p, const Region& q);

}  // namespace minksum::bench

// Finds cells that lie inside a small sum, so that segments in them can be left out.
#pragma once

#include <array>
#include <vector>

#include "sum/cover/cover.hpp"
#include "sum/small/small_sum.hpp"

namespace minksum {

/// A cover, and the memory for it.
struct SmallCover {
  Cover cover;
  CoverScratch scratch;
  std::array<std::vector<SiteId>, 2> next;  ///< by edge of an operand: the vertex at its end
};

/// Marks cells inside the sum if the segments have many crossings, and if that is cheap beside what
/// they take.
void cover_small(const SmallPlan& plan, const SmallOperand& p, const SmallOperand& q,
                 SmallCover& cover);

}  // namespace minksum

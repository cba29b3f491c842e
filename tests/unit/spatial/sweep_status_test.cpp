// Tests the ordered list of a sweep against a plain list.
#include "spatial/sweep_status.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace minksum {
namespace {

using test::Random;

TEST(SweepStatus, KeepsItsOrder) {
  Random random(3);
  SweepStatus status;
  std::vector<std::pair<SlotId, std::uint32_t>> expected;  // from below
  std::uint32_t next = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool grow = expected.empty() || random.below(1000) < 520;
    const int place = random.below(static_cast<int>(expected.size()) + 1);
    const auto at = expected.begin() + place;
    if (grow) {
      const SlotId below = place == 0 ? SweepStatus::kGround : (at - 1)->first;
      expected.insert(at, {status.insert_above(below, next), next});
      ++next;
    } else if (at != expected.end()) {
      status.erase(at->first);
      expected.erase(at);
    }
    if (i % 100 != 0) continue;
    SlotId slot = SweepStatus::kGround;
    for (const auto& [expected_slot, segment] : expected) {
      ASSERT_EQ(status.above(slot), expected_slot);
      ASSERT_EQ(status.below(expected_slot), slot);
      slot = expected_slot;
      ASSERT_EQ(status.segment(slot), segment);
    }
    ASSERT_EQ(status.above(slot), SweepStatus::kNone);
    // The search must find the segments up to some height.
    const int height = random.below(static_cast<int>(expected.size()) + 1);
    std::set<std::uint32_t> lower;
    for (int k = 0; k < height; ++k) lower.insert(expected[static_cast<std::size_t>(k)].second);
    const SlotId found = status.search([&](std::uint32_t p) { return lower.contains(p); });
    EXPECT_EQ(found, height == 0 ? SweepStatus::kGround
                                 : expected[static_cast<std::size_t>(height - 1)].first);
  }
}

}  // namespace
}  // namespace minksum

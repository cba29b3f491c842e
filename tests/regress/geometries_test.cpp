// Tests geometries that once were resolved or rounded wrongly. README.md says what was wrong.
#include "support/geometries.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "reference/brute_force_overlay.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

TEST(RegressGeometries, WidthJustAboveTwoToThe53) {
  constexpr std::int64_t kLimit = std::int64_t{1} << 53;
  RoundOptions to_integers;
  to_integers.decimals = 0;
  for (const std::int64_t width : {kLimit - 1, kLimit, kLimit + 1, kLimit + 2, kLimit + 3}) {
    const Geometry bent{
        make_polygon(
            {{0, 0}, {width - 6, 10}, {width - 2, 12}, {width, 13}, {width - 9, 20}, {0, 20}}),
        {},
        {}};
    const Geometry expected{
        make_polygon({{0, 0}, {width - 6, 10}, {width, 13}, {width - 9, 20}, {0, 20}}), {}, {}};
    const Geometry result = resolve(bent);
    EXPECT_EQ(to_text(result), to_text(expected));
    EXPECT_EQ(reference::resolved_fault(result), "");
    EXPECT_EQ(round(result, to_integers), expected);
  }
}

}  // namespace

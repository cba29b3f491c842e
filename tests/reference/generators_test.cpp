// Tests that generated regions are valid, varied and the same everywhere.
#include "support/generators.hpp"

#include <gtest/gtest.h>

#include <map>

#include "reference/validity.hpp"
#include "support/data.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace {

using minksum::reference::validity_fault;
using namespace minksum::test;

TEST(Generators, MakeValidRegionsOfAllSorts) {
  std::map<std::string, int> kinds;
  int with_holes = 0;
  int with_parts = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    ++kinds[pair.kind];
    for (const minksum::Region* region : {&pair.p, &pair.q}) {
      ASSERT_EQ(validity_fault(*region), "") << "seed " << seed << ' ' << to_text(*region);
      with_holes += region->hole_count() > 0 ? 1 : 0;
      with_parts += region->polygon_count() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(kinds.size(), 100U);
  EXPECT_GT(with_holes, 400);
  EXPECT_GT(with_parts, 400);
}

TEST(Generators, LargerShapesAreValid) {
  Random random(7);
  EXPECT_EQ(validity_fault(comb(30, 2, 9)), "");
  EXPECT_EQ(validity_fault(spiral(12)), "");
  EXPECT_EQ(validity_fault(spiky_star(random, 50, 100000)), "");
  EXPECT_EQ(validity_fault(round_polygon(64, 1000000)), "");
  EXPECT_EQ(spiral(12).vertex_count(), 96U);
}

TEST(Generators, NumbersAreTheSameEverywhere) {
  Random random(42);
  EXPECT_EQ(random.next(), 13679457532755275413U);
  EXPECT_EQ(random.next(), 2949826092126892291U);
}

TEST(Data, WktOfTheTestsIsReadExactly) {
  const auto region = parse_wkt("POLYGON ((0 0, 0.1 0, 1e-1 1/3, 0 0))");
  ASSERT_EQ(region.vertex_count(), 3U);
  EXPECT_EQ(region.exact_x(1), minksum::Rational(1, 10));
  EXPECT_EQ(region.exact_y(2), minksum::Rational(1, 3));
  EXPECT_THROW(static_cast<void>(parse_wkt("POLYGON ((0 0, 1")), std::runtime_error);
}

}  // namespace

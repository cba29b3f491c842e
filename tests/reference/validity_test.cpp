// Tests that the checkers can reject.
#include "reference/validity.hpp"

#include <gtest/gtest.h>

#include "minksum/validity.hpp"
#include "support/shapes.hpp"

namespace {

using minksum::Region;
using minksum::reference::canonical_fault;
using minksum::reference::validity_fault;
using namespace minksum::test;

const Outline kBox{{0, 0}, {8, 0}, {8, 8}, {0, 8}};

TEST(ValidityFault, AcceptsWhatIsValid) {
  EXPECT_EQ(validity_fault(Region{}), "");
  EXPECT_EQ(validity_fault(make_polygon(kBox, {{{2, 2}, {4, 2}, {2, 4}}})), "");
  // Any orientation, repeated vertices and straight vertices are valid.
  EXPECT_EQ(validity_fault(make_polygon({{0, 8}, {8, 8}, {8, 8}, {8, 0}, {4, 0}, {0, 0}})), "");
  // A hole may touch the outer ring in a vertex, and two holes may touch each other.
  EXPECT_EQ(
      validity_fault(make_polygon(kBox, {{{0, 4}, {2, 2}, {4, 4}}, {{4, 4}, {6, 2}, {6, 6}}})), "");
  // A part may lie in a hole of another part and touch it.
  EXPECT_EQ(validity_fault(make_region(
                {{kBox, {{2, 2}, {6, 2}, {6, 6}, {2, 6}}}, {{{2, 2}, {5, 3}, {3, 5}}}})),
            "");
}

TEST(ValidityFault, RejectsWhatIsNot) {
  const auto rejects = [](const Region& region) { return !validity_fault(region).empty(); };
  EXPECT_TRUE(rejects(make_polygon({{0, 0}, {1, 1}})));
  EXPECT_TRUE(rejects(make_polygon({{0, 0}, {1, 1}, {2, 2}})));
  EXPECT_TRUE(rejects(make_polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})));
  EXPECT_TRUE(rejects(make_polygon({{0, 0}, {4, 0}, {2, 0}, {2, 2}})));          // spike
  EXPECT_TRUE(rejects(make_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})));  // touches
  EXPECT_TRUE(rejects(make_polygon(kBox, {{{6, 6}, {10, 6}, {6, 7}}})));         // crosses
  EXPECT_TRUE(rejects(make_polygon(kBox, {{{9, 9}, {10, 9}, {9, 10}}})));        // outside
  EXPECT_TRUE(rejects(make_polygon(kBox, {{{0, 0}, {2, 0}, {0, 2}}})));          // overlap
  EXPECT_TRUE(rejects(make_polygon(kBox, {{{1, 1}, {6, 1}, {1, 6}}, {{2, 2}, {3, 2}, {2, 3}}})));
  EXPECT_TRUE(rejects(make_region({{kBox}, {{{2, 2}, {4, 2}, {2, 4}}}})));
  EXPECT_TRUE(rejects(make_region({{kBox}, {kBox}})));
  // The two triangles cross through a vertex of each.
  EXPECT_TRUE(rejects(
      make_region({{{{0, 0}, {4, 0}, {8, 0}, {4, 8}}}, {{{4, 0}, {6, -4}, {10, 6}, {4, 2}}}})));
}

TEST(CanonicalFault, WantsTheDocumentedForm) {
  const Outline hole{{2, 2}, {2, 4}, {4, 2}};
  EXPECT_EQ(canonical_fault(make_polygon(kBox, {hole})), "");
  const auto rejects = [](const Region& region) { return !canonical_fault(region).empty(); };
  EXPECT_TRUE(rejects(make_polygon({{0, 8}, {8, 8}, {8, 0}, {0, 0}})));          // clockwise
  EXPECT_TRUE(rejects(make_polygon({{8, 0}, {8, 8}, {0, 8}, {0, 0}})));          // start
  EXPECT_TRUE(rejects(make_polygon({{0, 0}, {4, 0}, {8, 0}, {8, 8}, {0, 8}})));  // straight
  EXPECT_TRUE(rejects(make_polygon(kBox, {{{2, 2}, {4, 2}, {2, 4}}})));          // hole ccw
  EXPECT_TRUE(rejects(make_polygon(kBox, {{{5, 5}, {5, 6}, {6, 5}}, hole})));    // order
  const Outline far{{10, 0}, {11, 0}, {11, 1}};
  EXPECT_TRUE(rejects(make_region({{far}, {kBox}})));  // order
  EXPECT_EQ(canonical_fault(make_region({{kBox}, {far}})), "");
}

}  // namespace

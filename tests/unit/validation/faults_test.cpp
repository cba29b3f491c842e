// Tests that faults have exact locations, and that each crossing is a fault of its own.
#include <gtest/gtest.h>

#include <algorithm>

#include "minksum/minkowski_sum.hpp"
#include "minksum/validity.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace minksum {
namespace {

using test::make_polygon;
using test::make_region;

std::vector<std::string> texts(const Region& region) {
  std::vector<std::string> result;
  for (const Fault& fault : validate(region)) result.push_back(to_string(fault));
  std::sort(result.begin(), result.end());
  return result;
}
using Texts = std::vector<std::string>;

TEST(Faults, ACrossingIsWhereEdgesCross) {
  const std::vector<Fault> faults = validate(make_polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}}));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].at, (Point{5, 5}));
  EXPECT_EQ(to_string(faults[0]), "edges cross at (5, 5)");
  EXPECT_EQ(std::min(faults[0].place.vertex, faults[0].other.vertex), 0U);
  EXPECT_EQ(std::max(faults[0].place.vertex, faults[0].other.vertex), 2U);
}

TEST(Faults, EachCrossingOfOneEdgeIsAFault) {
  // A zigzag crosses the first edge.
  const Region region =
      make_polygon({{0, 0}, {12, 0}, {12, 5}, {9, -2}, {7, 2}, {5, -2}, {3, 2}, {0, 5}});
  EXPECT_EQ(texts(region), (Texts{"edges cross at (4, 0)", "edges cross at (6, 0)",
                                  "edges cross at (69/7, 0)", "edges cross at (8, 0)"}));
}

TEST(Faults, OfAnOverlapTheFirstSharedPoint) {
  const Region two =
      make_region({{{{0, 0}, {6, 0}, {6, 4}, {0, 4}}}, {{{6, 1}, {9, 1}, {9, 7}, {6, 7}}}});
  const std::vector<Fault> faults = validate(two);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(to_string(faults[0]), "edges overlap at (6, 1)");
  EXPECT_NE(faults[0].place.polygon, faults[0].other.polygon);
}

TEST(Faults, VerticesInTheMiddleOfEdgesAreCountedIn) {
  // The straight edge has vertices, and the crossing is on its third part.
  const Region region = make_polygon({{0, 0}, {2, 0}, {4, 0}, {10, 0}, {10, 5}, {7, -3}, {0, 5}});
  for (const Fault& fault : validate(region)) {
    const std::size_t first = std::min(fault.place.vertex, fault.other.vertex);
    EXPECT_EQ(first, 2U) << to_string(fault);
  }
  EXPECT_EQ(validate(region).size(), 2U);
}

TEST(Faults, OfHolesTheEdgeIsCountedAsGiven) {
  // In both directions of the hole, the crossing edge starts at its vertex 1.
  for (const bool reversed : {false, true}) {
    test::Outline hole{{2, 2}, {2, 4}, {9, 3}};
    if (reversed) hole = {{9, 3}, {2, 4}, {2, 2}};
    const Region region = make_polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {hole});
    const std::vector<Fault> faults = validate(region);
    ASSERT_EQ(faults.size(), 2U);
    for (const Fault& fault : faults) {
      EXPECT_EQ(fault.at->x, Rational(6));
      const Culprit& in_hole = fault.place.ring == 1 ? fault.place : fault.other;
      const Culprit& in_outer = fault.place.ring == 1 ? fault.other : fault.place;
      EXPECT_EQ(in_outer.vertex, 1U);
      const std::size_t upper = reversed ? 0U : 1U;
      const std::size_t lower = 2U;
      EXPECT_EQ(in_hole.vertex, Rational(3) < fault.at->y ? upper : lower);
    }
  }
}

TEST(Faults, TouchesNameBothSides) {
  const std::vector<Fault> faults =
      validate(make_polygon({{0, 0}, {8, 0}, {8, 4}, {4, 0}, {0, 4}}));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(to_string(faults[0]), "ring touches itself at (4, 0)");
  EXPECT_EQ(faults[0].place.vertex, 3U);
  EXPECT_EQ(faults[0].other.vertex, 0U);
}

TEST(Faults, LongNumbersAreTold) {
  const Rational tiny(1, 1000003);
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.add_vertex(Rational(0), tiny);
  region.add_vertex(Rational(10), Rational(10) - tiny * tiny);
  region.add_vertex(Rational(10), Rational(0));
  region.add_vertex(Rational(0), Rational(10));
  const std::vector<Fault> faults = validate(region);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(to_string(faults[0]).substr(0, 25), "edges cross near (4.99999");
}

TEST(Faults, ErrorsTellThePlace) {
  const Region bow_tie = make_polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}});
  try {
    (void)minkowski_sum(bow_tie, bow_tie);
    FAIL() << "a bow tie was taken";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "edges cross at (5, 5)");
    EXPECT_EQ(error.culprit().operand, 0);
  }
}

TEST(Faults, ARingWithoutVerticesHasNoPlace) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const int x : {0, 1, 2}) region.add_vertex(x, x * x);
  region.begin_ring();
  const std::vector<Fault> faults = validate(region);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_FALSE(faults[0].at);
  EXPECT_EQ(to_string(faults[0]), faults[0].message);
}

/// Counts all crossings of the edges of one ring, by the definition.
std::size_t count_crossings(const std::vector<Point>& ring) {
  const auto side = [](const Point& a, const Point& b, const Point& c) {
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      const Point& a = ring[i];
      const Point& b = ring[(i + 1) % ring.size()];
      const Point& c = ring[j];
      const Point& d = ring[(j + 1) % ring.size()];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) ++count;
    }
  }
  return count;
}

TEST(Faults, AllCrossingsOfRandomRings) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    test::Random random(seed);
    Region region;
    region.begin_polygon();
    region.begin_ring();
    std::vector<Point> ring;
    for (int i = random.between(4, 40); i > 0; --i) {
      ring.push_back({random.between(0, 1000), random.between(0, 1000)});
      region.add_vertex(ring.back().x, ring.back().y);
    }
    std::size_t crossings = 0;
    for (const Fault& fault : validate(region, 100'000)) {
      if (fault.message == "edges cross") ++crossings;
    }
    EXPECT_EQ(crossings, count_crossings(ring)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace minksum

// Tests area, box and bits on every kind of stored number.
#include "minksum/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace minksum {
namespace {

void add_ring(Region& region, std::initializer_list<std::pair<Rational, Rational>> points) {
  region.begin_ring();
  for (const auto& [x, y] : points) region.add_vertex(x, y);
}

Region square_with_hole(const Rational& unit, const Rational& offset) {
  const auto at = [&](int value) { return Rational(value) * unit + offset; };
  Region region;
  region.begin_polygon();
  add_ring(region, {{at(0), at(0)}, {at(4), at(0)}, {at(4), at(4)}, {at(0), at(4)}});
  add_ring(region, {{at(1), at(1)}, {at(2), at(1)}, {at(2), at(2)}});  // counter-clockwise as well
  return region;
}

TEST(Measure, AreaIsExactForEveryKindOfNumber) {
  const Rational expected(31, 2);
  for (const Rational& unit :
       {Rational(1), Rational(1, 10), Rational(1, 3), Rational(0.1), Rational(Decimal{1, 30}),
        Rational(Decimal{7, -25}), Rational(std::ldexp(1.0, 70))}) {
    for (const Rational& offset : {Rational(0), Rational(-5), Rational(1, 7)}) {
      const Region region = square_with_hole(unit, offset);
      EXPECT_EQ(area(region), expected * unit * unit) << unit << ' ' << offset;
    }
  }
  EXPECT_EQ(area(Region()), Rational(0));
}

TEST(Measure, AreaOfManyDenominatorsIsInLowestTerms) {
  // The denominators have factors in common with each other and with the numerator of the sum.
  test::Random random(71);
  for (const int count : {3, 40, 400}) {
    Region region;
    region.begin_polygon();
    region.begin_ring();
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
      const std::int64_t shared = std::int64_t{1} << random.below(40);
      const Rational divisor = Rational(1 + random.below(1'000'000)) *
                               Rational(shared + random.below(9)) *
                               Rational(i % 3 == 0 ? 1 : 3 * 5 * 7 + random.below(3));
      points.push_back({Rational(random.below(1'000'000)) / divisor,
                        Rational(random.below(1'000'000)) / divisor});
      region.add_vertex(points.back().x, points.back().y);
    }
    Rational doubled;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      const Point& q = points[(i + 1) % points.size()];
      doubled += p.x * q.y - q.x * p.y;
    }
    const Rational expected = (doubled.sign() < 0 ? -doubled : doubled) * Rational(1, 2);
    const Rational found = area(region);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.to_string(), expected.to_string());
  }
}

TEST(Measure, AreaIgnoresOrientation) {
  Region region;
  region.begin_polygon();
  add_ring(region, {{0, 0}, {0, 4}, {4, 4}, {4, 0}});
  add_ring(region, {{1, 1}, {2, 1}, {2, 2}});
  EXPECT_EQ(area(region), Rational(31, 2));
}

// The slow and obvious area is the sum of triangles around a centre far away.
TEST(Measure, AreaOfLargeNumbersDoesNotOverflow) {
  constexpr std::int64_t kFar = (std::int64_t{1} << 61) - 1;
  Region region;
  region.begin_polygon();
  region.begin_ring();
  region.add_vertex(-kFar, -kFar);
  region.add_vertex(kFar, -kFar);
  region.add_vertex(kFar, kFar);
  region.add_vertex(-kFar, kFar);
  const Rational side = Rational(kFar) * Rational(2);
  EXPECT_EQ(area(region), side * side);
  EXPECT_EQ(approximate_area(region), (side * side).to_double());
}

TEST(Measure, BothWaysToTheAreaAgree) {
  test::Random random(21);
  for (int round = 0; round < 200; ++round) {
    Region integers;
    Region thirds;
    for (Region* region : {&integers, &thirds}) {
      region->begin_polygon();
      region->begin_ring();
    }
    const int count = random.between(3, 12);
    for (int i = 0; i < count; ++i) {
      const int x = random.between(-1000, 1000);
      const int y = random.between(-1000, 1000);
      integers.add_vertex(x, y);
      thirds.add_vertex(Rational(x, 3), Rational(y, 3));
    }
    EXPECT_EQ(area(integers), area(thirds) * Rational(9));
    EXPECT_NEAR(approximate_area(integers), area(integers).to_double(), 1e-6);
  }
}

TEST(Measure, AreaInDoublesIsGoodWhereCoordinatesAreNone) {
  for (const char* const at : {"10000000000000000", "1", "-1e300"}) {
    const Rational low = *Rational::parse(at);
    for (const char* const side : {"3", "1/3", "1e-15"}) {
      const Rational high = low + *Rational::parse(side);
      const Region box(Polygon{{{low, low}, {high, low}, {high, high}, {low, high}}, {}});
      const double exact = area(box).to_double();
      EXPECT_NEAR(approximate_area(box), exact, 1e-9 * exact) << at << ' ' << side;
    }
  }
}

// Compares with the sum by definition. Denominators may be equal, neighbours or not, may have
// common divisors, or may be 1; doubles and decimals are among the numbers.
TEST(Measure, AreaAndBitsOfManyDenominators) {
  test::Random random(12);
  const Rational below[] = {1,
                            3,
                            3,
                            7,
                            12,
                            21,
                            Rational(1) / Rational(0.375),
                            10,
                            *Rational::parse("1000000000000000000000000000057"),
                            *Rational::parse("3000000000000000000000000000171")};
  for (int round = 0; round < 300; ++round) {
    Region region;
    Rational doubled;
    Rational grid = 1;
    const auto coordinate = [&] {
      const Rational value =
          Rational(random.between(-1000, 1000)) / below[random.below(round % 10 + 1)];
      // The grid becomes the least common multiple step by step.
      const Rational missing = (grid * value).denominator();
      grid = grid * missing;
      return value;
    };
    for (int polygon = random.between(1, 3); polygon > 0; --polygon) {
      region.begin_polygon();
      const int rings = random.between(1, 3);
      for (int ring = 0; ring < rings; ++ring) {
        region.begin_ring();
        std::vector<Point> points;
        for (int i = random.between(1, 9); i > 0; --i) {
          points.push_back({coordinate(), coordinate()});
        }
        Rational sum;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const Point& p = points[i];
          const Point& q = points[(i + 1) % points.size()];
          sum = sum + p.x * q.y - q.x * p.y;
          region.add_vertex(p.x, p.y);
        }
        if (sum.sign() < 0) sum = -sum;
        doubled = ring == 0 ? doubled + sum : doubled - sum;
      }
    }
    EXPECT_EQ(area(region), doubled / Rational(2)) << "round " << round;
    const auto box = bounding_box(region);
    const Rational width = (box->max.x - box->min.x) * grid;
    const Rational height = (box->max.y - box->min.y) * grid;
    ASSERT_TRUE(width.is_integer() && height.is_integer());
    EXPECT_EQ(coordinate_bits(region), std::max(width.sign() == 0 ? 0 : width.bits(),
                                                height.sign() == 0 ? 0 : height.bits()))
        << "round " << round;
  }
}

TEST(Measure, ApproximateAreaSurvivesExtremes) {
  for (const double unit : {1e-160, 5e-324, 1e160, 1e300}) {
    const Region region = square_with_hole(Rational(unit), Rational(0));
    const double expected = (Rational(31, 2) * Rational(unit) * Rational(unit)).to_double();
    EXPECT_EQ(approximate_area(region), expected) << unit;
  }
}

TEST(Measure, BoxIsExact) {
  EXPECT_FALSE(bounding_box(Region()).has_value());
  Region region;
  region.begin_polygon();
  region.begin_ring();
  const Rational tiny = *Rational::parse("1e-40");  // vanishes beside 1 in doubles
  region.add_vertex(Rational(1), Rational(1, 3));
  region.add_vertex(Rational(1) + tiny, Rational(1, 3) - tiny);
  region.add_vertex(Rational(1) - tiny, Rational(1, 3) + tiny);
  region.add_vertex(Decimal{10, -1}, Decimal{1, -1});
  const std::optional<Box> box = bounding_box(region);
  ASSERT_TRUE(box.has_value());
  EXPECT_EQ(box->min.x, Rational(1) - tiny);
  EXPECT_EQ(box->max.x, Rational(1) + tiny);
  EXPECT_EQ(box->min.y, Rational(1, 10));
  EXPECT_EQ(box->max.y, Rational(1, 3) + tiny);
}

TEST(Measure, BitsAreThoseOfTheGridAtTheOrigin) {
  EXPECT_EQ(coordinate_bits(Region()), 0U);
  EXPECT_EQ(coordinate_bits(square_with_hole(1, 0)), 3U);
  EXPECT_EQ(coordinate_bits(square_with_hole(1, 1000000)), 3U);
  EXPECT_EQ(coordinate_bits(square_with_hole(Rational(1, 10), 0)), 3U);  // 0, 2, 4, ... of 1/10
  EXPECT_EQ(coordinate_bits(square_with_hole(Rational(1, 10), Rational(1, 4))), 4U);  // 8/20
  EXPECT_EQ(coordinate_bits(square_with_hole(Rational(1, 3), Rational(1, 7))), 5U);   // 28/21
  EXPECT_EQ(coordinate_bits(square_with_hole(1, Rational(Decimal{5, -1}))), 4U);      // 8/2
  Region decimals;
  decimals.begin_polygon();
  decimals.begin_ring();
  decimals.add_vertex(Decimal{0, 0}, Decimal{50, -2});
  decimals.add_vertex(Decimal{2500, -3}, Decimal{0, 0});
  decimals.add_vertex(0.5, 1.5);
  EXPECT_EQ(coordinate_bits(decimals), 3U);  // halves: 5 of them
}

}  // namespace
}  // namespace minksum

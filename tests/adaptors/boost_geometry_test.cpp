#include "minksum/adaptors/boost_geometry.hpp"

#include <gtest/gtest.h>

#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "adaptors/sources.hpp"
#include "minksum/measure.hpp"

namespace bg = boost::geometry;

namespace {
using Fraction = boost::multiprecision::cpp_rational;
}

namespace minksum::adaptors {
// A user writes this for another number type.
template <>
struct NumberTraits<Fraction> {
  static Rational to_rational(const Fraction& number) { return *Rational::parse(number.str()); }
  static Fraction from_rational(const Rational& value) { return Fraction(value.to_string()); }
};
}  // namespace minksum::adaptors

namespace minksum::test {
namespace {

using adaptors::from_boost;
using adaptors::to_boost;

template <class Number, bool kClockwise, bool kClosed>
using Multi = bg::model::multi_polygon<
    bg::model::polygon<bg::model::d2::point_xy<Number>, kClockwise, kClosed>>;
using PlainMulti = Multi<double, true, true>;
using PlainPolygon = PlainMulti::value_type;

template <class Multi>
class BoostGeometry : public testing::Test {};
using Kinds = testing::Types<Multi<double, true, true>, Multi<double, true, false>,
                             Multi<double, false, true>, Multi<double, false, false>,
                             Multi<float, true, true>, Multi<int, false, true>,
                             Multi<std::int64_t, true, false>, Multi<Fraction, true, true>>;
TYPED_TEST_SUITE(BoostGeometry, Kinds);

// Rings have the direction of their type, and the closing point if the type wants one.
TYPED_TEST(BoostGeometry, RoundTrips) {
  Random random(seed_from_environment(11));
  for (int i = 0; i < 200; ++i) {
    const Region region = random_source(random);
    for (const Region& written : {region, scrambled(region, random)}) {
      const auto there = to_boost<TypeParam>(written);
      ASSERT_EQ(there.size(), region.polygon_count());
      const Region back = from_boost(there);
      ASSERT_EQ(back.ring_count(), written.ring_count()) << to_text(written);
      ASSERT_EQ(canonical(back), region) << to_text(written);
      for (const auto& polygon : there) {
        ASSERT_GT(bg::area(polygon), 0) << to_text(written);
        for (const auto& hole : polygon.inners()) {
          ASSERT_LT(bg::area(hole), 0) << to_text(written);
          // A ring that repeats its own first vertex at its end closes itself.
          const bool closed = bg::closure<TypeParam>::value == bg::closed;
          if (written == region) {
            ASSERT_EQ(bg::equals(hole.front(), hole.back()), closed);
          }
        }
      }
    }
  }
}

TYPED_TEST(BoostGeometry, IsExactOrRefuses) {
  const Region third = scaled(frame_and_triangle(), Rational(1, 3));
  using Number = typename bg::coordinate_type<TypeParam>::type;
  if constexpr (std::is_integral_v<Number>) {
    const Error error = error_of([&] { (void)to_boost<TypeParam>(third); });
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    // The holes' coordinates 1 and 2, and the outer ring's 0 and 3, are integers.
    EXPECT_EQ(place_of(error), "1 0 0");
    EXPECT_STREQ(error.what(),
                 "the coordinate 20/3 is not an integer: polygon 1, ring 0, vertex 0");
  } else {
    const Region back = from_boost(to_boost<TypeParam>(third));
    EXPECT_EQ(canonical(back) == canonical(third), !std::is_floating_point_v<Number>);
    EXPECT_EQ(canonical(back).polygon_count(), 2U);
  }
}

TYPED_TEST(BoostGeometry, NothingIsNothing) {
  EXPECT_TRUE(to_boost<TypeParam>(Region()).empty());
  EXPECT_EQ(from_boost(TypeParam()), Region());
  EXPECT_EQ(from_boost(typename TypeParam::value_type()), Region());
  EXPECT_TRUE(to_boost<typename TypeParam::value_type>(Region()).outer().empty());
  Region begun;
  begun.begin_polygon();
  EXPECT_TRUE(to_boost<TypeParam>(begun).empty());
}

TYPED_TEST(BoostGeometry, LeavesOutEmptyRings) {
  EXPECT_EQ(canonical(from_boost(to_boost<TypeParam>(with_empty_rings()))), without_empty_rings());
  const auto single = to_boost<typename TypeParam::value_type>(with_empty_rings());
  EXPECT_EQ(single.inners().size(), 1U);
  const Error error = error_of([] { (void)to_boost<TypeParam>(hole_alone()); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "0 0 -");
}

TEST(BoostGeometryDoubles, ValidRegionsAreValidThere) {
  Random random(seed_from_environment(12));
  for (int i = 0; i < 100; ++i) {
    const Region region = canonical(random_convex(random, 8, 24));
    std::string why;
    EXPECT_TRUE(bg::is_valid(to_boost<PlainMulti>(region), why)) << why << to_text(region);
  }
  EXPECT_TRUE(bg::is_valid(to_boost<PlainMulti>(frame_and_triangle())));
}

TEST(BoostGeometryDoubles, AreExact) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  PlainPolygon polygon;
  polygon.outer() = {{0, 0}, {0.1, huge}, {huge, tiny}, {0, 0}};
  const Region region = from_boost(polygon);
  EXPECT_EQ(region.vertex_count(), 3U);
  EXPECT_EQ(region.exact_x(1), Rational(0.1));
  EXPECT_EQ(region.exact_y(2), Rational(tiny));
  EXPECT_TRUE(bg::equals(to_boost<PlainPolygon>(region).outer()[1], polygon.outer()[1]));
}

// Rounding twice, to a double and then to a float, would give the wrong float.
TEST(BoostGeometryFloats, AreTheNearest) {
  const float one_up = std::nextafter(1.0F, 2.0F);
  const Rational middle = (Rational(1) + Rational(one_up)) / Rational(2);
  const Rational little(1, std::int64_t{1} << 62U);
  const Region region(Polygon{
      {{0, 0}, {middle + little, 1}, {-middle - little, 2}, {middle, 3}, {middle - little, 4}},
      {}});
  using Float = Multi<float, true, false>::value_type;
  std::vector<float> xs;
  const auto polygon = to_boost<Float>(region);
  for (const auto& point : polygon.outer()) xs.push_back(point.x());
  EXPECT_EQ(xs, (std::vector<float>{0, one_up, -one_up, 1, 1}));
}
// Floats end at the middle between the largest one and the next power of two.
TEST(BoostGeometryFloats, EndWhereNumbersRoundToNoFloat) {
  using Float = Multi<float, true, false>::value_type;
  constexpr float kLargest = std::numeric_limits<float>::max();
  const Rational middle(0x1.ffffffp+127);
  const auto written = [](const Rational& x) {
    return to_boost<Float>(Region(Polygon{{{-x, 0}, {x, 0}, {0, 1}}, {}})).outer();
  };
  const auto ring = written(middle - Rational(1));
  EXPECT_EQ(ring[0].x(), -kLargest);
  EXPECT_TRUE(
      std::any_of(ring.begin(), ring.end(), [](const auto& p) { return p.x() == kLargest; }));
  EXPECT_THROW((void)written(middle), Error);
  EXPECT_THROW((void)written(middle + Rational(1)), Error);
}

TEST(BoostGeometryErrors, Tell) {
  PlainMulti multi;
  multi.resize(2);
  multi[0].outer() = {{0, 0}, {0, 9}, {9, 9}, {0, 0}};
  multi[1] = multi[0];
  multi[1].inners().push_back({{1, 2}, {2, 3}, {std::nan(""), 3}, {1, 2}});
  Error error = error_of([&] { (void)from_boost(multi); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "1 1 2");

  multi[1].inners()[0][2] = {std::numeric_limits<double>::infinity(), 0};
  EXPECT_EQ(place_of(error_of([&] { (void)from_boost(multi); })), "1 1 2");

  multi[1].inners()[0][2] = {1, 3};
  multi[1].outer().clear();
  error = error_of([&] { (void)from_boost(multi); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "1 0 -");

  error = error_of([] { (void)to_boost<PlainPolygon>(frame_and_triangle()); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "1 - -");

  const Region far = scaled(frame_and_triangle(), Rational(Decimal{1, 400}));
  error = error_of([&] { (void)to_boost<PlainMulti>(far); });
  EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
  // The first vertex is 0, and the next one in this direction is the region's last.
  EXPECT_EQ(place_of(error), "0 0 3");
  EXPECT_EQ(error.limit()->name, "doubles");
  const Region far_for_int = scaled(frame_and_triangle(), Rational(1'000'000'000));
  error = error_of([&] { (void)to_boost<Multi<int, true, true>>(far_for_int); });
  EXPECT_EQ(error.code(), ErrorCode::kLimitExceeded);
  EXPECT_EQ(error.limit()->name, "integers");
}

// Nothing is checked on the way in, so the library finds the faults itself.
TEST(BoostGeometryShortRings, StayAsTheyAre) {
  PlainPolygon polygon;
  polygon.outer() = {{1, 2}, {3, 4}, {1, 2}};
  EXPECT_EQ(from_boost(polygon).vertex_count(), 2U);
  EXPECT_EQ(to_boost<PlainPolygon>(from_boost(polygon)).outer().size(), 3U);
  polygon.outer() = {{1, 2}};
  EXPECT_EQ(from_boost(polygon).vertex_count(), 1U);
  polygon.outer() = {{1, 2}, {1, 2}};
  EXPECT_EQ(from_boost(polygon).vertex_count(), 1U);
  polygon.inners().emplace_back();
  EXPECT_EQ(from_boost(polygon).ring_count(), 1U);
}

}  // namespace
}  // namespace minksum::test

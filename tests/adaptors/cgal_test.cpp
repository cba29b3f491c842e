#include "minksum/adaptors/cgal.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <cmath>
#include <list>
#include <vector>

#include "adaptors/sources.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::test {
namespace {

using adaptors::from_cgal;
using adaptors::to_cgal;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <class Kernel>
using WithHoles = CGAL::Polygon_with_holes_2<Kernel>;
template <class Kernel>
using Many = std::vector<WithHoles<Kernel>>;

template <class Kernel>
class Cgal : public testing::Test {};
using Kernels = testing::Types<Epeck, Epick, CGAL::Simple_cartesian<CGAL::Exact_rational>,
                               CGAL::Simple_cartesian<CGAL::Quotient<CGAL::MP_Float>>,
                               CGAL::Simple_cartesian<double>, CGAL::Simple_cartesian<int>>;
TYPED_TEST_SUITE(Cgal, Kernels);

TYPED_TEST(Cgal, RoundTrips) {
  Random random(seed_from_environment(41));
  for (int i = 0; i < 50; ++i) {
    const Region region = random_source(random);
    for (const Region& written : {region, scrambled(region, random)}) {
      const auto there = to_cgal<Many<TypeParam>>(written);
      ASSERT_EQ(there.size(), region.polygon_count());
      ASSERT_EQ(canonical(from_cgal(there)), region) << to_text(written);
      if (written != region) continue;
      ASSERT_EQ(from_cgal(there), region) << to_text(written);
      for (const auto& polygon : there) {
        ASSERT_TRUE(polygon.outer_boundary().is_counterclockwise_oriented());
        for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
          ASSERT_TRUE(hole->is_clockwise_oriented());
        }
      }
    }
  }
}

TYPED_TEST(Cgal, IsExactOrRefuses) {
  using Number = typename TypeParam::FT;
  // The numbers are fractions of a few bits and of thousands of digits.
  Rational longer = Rational(1, 3);
  for (int i = 0; i < 12; ++i) longer = longer * longer;
  for (const Rational& factor : {Rational(-1, 3), Rational(Decimal{1, -5}) + longer}) {
    const Region region = scaled(frame_and_triangle(), factor);
    if constexpr (std::is_integral_v<Number>) {
      const Error error = error_of([&] { (void)to_cgal<Many<TypeParam>>(region); });
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
      EXPECT_NE(error.culprit().vertex, Culprit::kNone);
    } else {
      const Region back = from_cgal(to_cgal<Many<TypeParam>>(region));
      EXPECT_EQ(canonical(back) == canonical(region), !std::is_floating_point_v<Number>);
      EXPECT_EQ(canonical(back).hole_count(), 1U);
    }
  }
}

TYPED_TEST(Cgal, TakesSinglePolygonsAndRanges) {
  const Region square = rectangle(0, 0, 9, 9);
  const Region frame = make_polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 6}, {6, 3}}});
  const auto simple = to_cgal<CGAL::Polygon_2<TypeParam>>(square);
  EXPECT_EQ(simple.size(), 4U);
  EXPECT_EQ(from_cgal(simple), square);
  EXPECT_EQ(from_cgal(WithHoles<TypeParam>(simple)), square);
  EXPECT_EQ(from_cgal(to_cgal<WithHoles<TypeParam>>(frame)), frame);
  EXPECT_EQ(from_cgal(to_cgal<std::list<CGAL::Polygon_2<TypeParam>>>(square)), square);

  const auto refused = [](const auto& run) {
    const Error error = error_of(run);
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    return place_of(error);
  };
  EXPECT_EQ(refused([&] { (void)to_cgal<CGAL::Polygon_2<TypeParam>>(frame); }), "0 1 -");
  EXPECT_EQ(refused([&] { (void)to_cgal<WithHoles<TypeParam>>(frame_and_triangle()); }), "1 - -");
  EXPECT_EQ(refused([&] { (void)to_cgal<WithHoles<TypeParam>>(Region()); }), "- - -");
  // A polygon without an outer boundary is the plane less the holes.
  EXPECT_EQ(refused([] { (void)from_cgal(Many<TypeParam>(1)); }), "0 0 -");

  EXPECT_TRUE(to_cgal<CGAL::Polygon_2<TypeParam>>(Region()).is_empty());
  EXPECT_TRUE(to_cgal<Many<TypeParam>>(Region()).empty());
  EXPECT_EQ(from_cgal(CGAL::Polygon_2<TypeParam>()), Region());
  EXPECT_EQ(from_cgal(Many<TypeParam>()), Region());
}

TYPED_TEST(Cgal, LeavesOutEmptyRings) {
  EXPECT_EQ(from_cgal(to_cgal<Many<TypeParam>>(with_empty_rings())), without_empty_rings());
  EXPECT_EQ(to_cgal<WithHoles<TypeParam>>(with_empty_rings()).number_of_holes(), 1U);
  const Error error = error_of([] { (void)to_cgal<Many<TypeParam>>(hole_alone()); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "0 0 -");
}

TYPED_TEST(Cgal, LeavesOutTheClosingPoint) {
  CGAL::Polygon_2<TypeParam> closed;
  for (const auto& [x, y] : {std::pair(0, 0), {9, 0}, {9, 9}, {0, 0}}) {
    closed.push_back({x, y});
  }
  EXPECT_EQ(from_cgal(closed), make_polygon({{0, 0}, {9, 0}, {9, 9}}));
}

TEST(CgalDoubles, NameWhatIsNotFinite) {
  const double nan = std::nan("");
  CGAL::Polygon_2<CGAL::Simple_cartesian<double>> outer;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {9.0, 0.0}, {nan, 9.0}}) outer.push_back({x, y});
  const Error error = error_of([&] { (void)from_cgal(outer); });
  EXPECT_EQ(error.code(), ErrorCode::kBadInput);
  EXPECT_EQ(place_of(error), "0 0 2");
  const Region far = scaled(frame_and_triangle(), Rational(Decimal{1, 400}));
  EXPECT_EQ(error_of([&] { (void)to_cgal<Many<Epick>>(far); }).code(), ErrorCode::kLimitExceeded);
  EXPECT_EQ(from_cgal(to_cgal<Many<Epeck>>(far)), canonical(far));
}

// The coordinates are numbers that CGAL has computed, not only given ones.
TEST(CgalExact, TakesLazyNumbers) {
  const Epeck::FT third = Epeck::FT(1) / Epeck::FT(3);
  CGAL::Polygon_2<Epeck> polygon;
  for (const auto& [x, y] : {std::pair(0, 0), {9, 0}, {9, 7}}) {
    polygon.push_back({x * third, y * third * third - third});
  }
  const Region region = from_cgal(polygon);
  EXPECT_EQ(region.exact_x(1), Rational(3));
  EXPECT_EQ(region.exact_y(1), Rational(-1, 3));
  EXPECT_EQ(region.exact_y(2), Rational(4, 9));
  EXPECT_TRUE(to_cgal<CGAL::Polygon_2<Epeck>>(region) == polygon);
}

}  // namespace
}  // namespace minksum::test

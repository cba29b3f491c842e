// Tests the container: structure, exact storage of every kind of number, equality, and misuse.
#include "minksum/region.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <future>
#include <limits>
#include <utility>
#include <vector>

#include "minksum/geometry.hpp"
#include "region/region_access.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "support/threads.hpp"

namespace minksum {
namespace {

Region open_ring() {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  return region;
}

template <typename Number>
Region with_vertex(const Number& x, const Number& y) {
  Region region = open_ring();
  region.add_vertex(x, y);
  return region;
}

Region two_polygons() {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : {std::pair{0, 0}, {9, 0}, {9, 9}, {0, 9}}) region.add_vertex(x, y);
  region.begin_ring();
  for (const auto& [x, y] : {std::pair{3, 3}, {6, 3}, {6, 6}}) region.add_vertex(x, y);
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : {std::pair{20, 0}, {21, 0}, {20, 1}}) region.add_vertex(x, y);
  return region;
}

TEST(Region, KnowsItsStructure) {
  const Region region = two_polygons();
  EXPECT_EQ(region.polygon_count(), 2U);
  EXPECT_EQ(region.ring_count(), 3U);
  EXPECT_EQ(region.hole_count(), 1U);
  EXPECT_EQ(region.vertex_count(), 10U);
  EXPECT_EQ(region.rings_of(0).size(), 2U);
  EXPECT_EQ(region.vertices_of(1).front(), 4U);
  EXPECT_EQ(region.vertices_of(2).size(), 3U);
  EXPECT_FALSE(region.has_origins());
  EXPECT_TRUE(Region().empty());
}

TEST(Region, GoesThroughPolygonsAndBack) {
  const Region region = two_polygons();
  const std::vector<Polygon> polygons = {region.polygon(0), region.polygon(1)};
  EXPECT_EQ(polygons[0].outer.size(), 4U);
  EXPECT_EQ(polygons[0].holes.size(), 1U);
  EXPECT_EQ(Region(polygons), region);
  EXPECT_EQ(Region(polygons[0]).ring_count(), 2U);
}

TEST(Region, FindsThePlaceOfAVertex) {
  const Region region = two_polygons();
  const Culprit place = RegionAccess::culprit(region, 5, 1);
  EXPECT_EQ(place.operand, 1);
  EXPECT_EQ(place.polygon, 0U);
  EXPECT_EQ(place.ring, 1U);
  EXPECT_EQ(place.vertex, 1U);
  EXPECT_EQ(RegionAccess::culprit(region, 7).polygon, 1U);
  EXPECT_EQ(RegionAccess::culprit(region, 7).ring, 0U);
}

TEST(Region, EqualityIsThatOfNumbersNotOfForms) {
  const Region half = with_vertex(0.5, -0.5);
  EXPECT_EQ(half, with_vertex(Decimal{5, -1}, Decimal{-5, -1}));
  EXPECT_EQ(half, with_vertex(Decimal{500, -3}, Decimal{-50, -2}));
  EXPECT_EQ(half, with_vertex(Rational(1, 2), Rational(-1, 2)));
  EXPECT_NE(half, with_vertex(0.5, 0.5));
  EXPECT_NE(with_vertex(0.1, 0.0), with_vertex(Decimal{1, -1}, Decimal{}));
  EXPECT_EQ(with_vertex(1e300, 0.0), with_vertex(Rational(1e300), Rational(0)));
  EXPECT_EQ(with_vertex(Rational(1, 3), Rational(2, 7)),
            with_vertex(Rational(1, 3), Rational(2, 7)));
  EXPECT_NE(with_vertex(Rational(1, 3), Rational(2, 7)),
            with_vertex(Rational(1, 3), Rational(3, 7)));
  Region other_structure = half;
  other_structure.begin_ring();
  EXPECT_NE(half, other_structure);
}

TEST(Region, KeepsEveryNumberExactly) {
  test::Random random(11);
  constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();
  std::vector<Rational> values = {
      Rational(0),      Rational(kLowest),          Rational(1, kLowest),
      Rational(1, 3),   Rational(Decimal{1, 40}),   Rational(Decimal{-123456789, -30}),
      Rational(5e-324), *Rational::parse("1e4096"), *Rational::parse("-7e-4096")};
  for (int i = 0; i < 300; ++i) {
    values.emplace_back(static_cast<std::int64_t>(random.next()) >> random.below(64),
                        static_cast<std::int64_t>((random.next() >> (1 + random.below(63))) | 1U));
    values.push_back(values[values.size() - 2] * values.back());
  }
  Region region = open_ring();
  for (const Rational& value : values) region.add_vertex(value, -value);
  for (std::size_t v = 0; v < values.size(); ++v) {
    EXPECT_EQ(region.exact_x(v), values[v]);
    EXPECT_EQ(region.exact_y(v), -values[v]);
    EXPECT_EQ(region.x(v), values[v].to_double());
    EXPECT_EQ(region.y(v), -values[v].to_double());
  }
}

TEST(Region, DoublesMeanThemselves) {
  test::Random random(12);
  for (int i = 0; i < 5000; ++i) {
    const auto value = std::bit_cast<double>(random.next());
    if (!std::isfinite(value)) continue;
    const Region region = with_vertex(value, -value);
    EXPECT_EQ(region.exact_x(0), Rational(value));
    EXPECT_EQ(region.x(0), value);
    EXPECT_EQ(region.y(0), -value);
  }
  EXPECT_FALSE(std::signbit(with_vertex(-0.0, 0.0).x(0)));
}

TEST(Region, DecimalsRoundToTheNearestDouble) {
  test::Random random(13);
  for (int i = 0; i < 20000; ++i) {
    const Decimal value{static_cast<std::int64_t>(random.next()) >> random.below(64),
                        random.between(-350, 320)};
    const Region region = with_vertex(value, Decimal{});
    EXPECT_EQ(region.x(0), Rational(value).to_double()) << value.mantissa << 'e' << value.exponent;
  }
}

TEST(Region, TakesExponentsBeyondItsCompactForm) {
  const Region region = with_vertex(Decimal{3, 40000}, Decimal{3, -40000});
  EXPECT_EQ(region.exact_x(0), Rational(Decimal{3, 40000}));
  EXPECT_EQ(region.exact_y(0), Rational(Decimal{3, -40000}));
  EXPECT_EQ(region.x(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(region.y(0), 0);
  EXPECT_EQ(with_vertex(Decimal{-1, 30000}, Decimal{}).x(0),
            -std::numeric_limits<double>::infinity());
}

TEST(Region, MultiplesOfDecimalsAreCompact) {
  for (const char* const text : {"15e-4", "15e-40", "15e-322"}) {
    const Rational product = *Rational::parse(text) * Rational(151, 10);
    Region region;
    region.begin_polygon();
    region.begin_ring();
    region.add_vertex(product, -product);
    EXPECT_EQ(RegionAccess::x(region, 0).denominator_limbs, 0) << text;
    EXPECT_EQ(region.exact_x(0), product) << text;
    EXPECT_EQ(region.exact_y(0), -product) << text;
  }
}

TEST(Region, LongDecimalsAreIntegersTimesPowers) {
  // Both have a numerator of more than 64 bits. The first one's denominator has few twos.
  for (const char* const text : {"1234567890123456.789012345678", "-7e-19"}) {
    const Rational value = *Rational::parse(text) + Rational(std::int64_t{1} << 62);
    Region region;
    region.begin_polygon();
    region.begin_ring();
    region.add_vertex(value, Rational(0));
    const StoredCoordinate& x = RegionAccess::x(region, 0);
    EXPECT_EQ(x.denominator_limbs, 1) << text;
    EXPECT_EQ(
        RegionAccess::limbs(
            region)[static_cast<std::size_t>(x.payload) + (x.numerator_limbs & kLimbCountMask)],
        1U);
    EXPECT_LT(x.exp10, 0);
    EXPECT_EQ(region.exact_x(0), value) << text;
    EXPECT_EQ(region.x(0), value.to_double()) << text;
  }
}

TEST(Region, NamesTheVertexThatIsNotFinite) {
  Region region = two_polygons();
  region.begin_ring();
  region.add_vertex(1.0, 1.0);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    try {
      region.add_vertex(1.0, bad);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
      EXPECT_EQ(error.culprit().polygon, 1U);
      EXPECT_EQ(error.culprit().ring, 1U);
      EXPECT_EQ(error.culprit().vertex, 1U);
    }
  }
  EXPECT_EQ(region.vertex_count(), 11U);
}

TEST(Region, RefusesVerticesWithoutARing) {
  Region region;
  EXPECT_THROW(region.begin_ring(), Error);
  EXPECT_THROW(region.add_vertex(1, 2), Error);
  region.begin_polygon();
  EXPECT_THROW(region.add_vertex(1.0, 2.0), Error);
  region.begin_ring();
  region.add_vertex(1, 2);
  region.begin_polygon();
  EXPECT_THROW(region.add_vertex(Rational(1), Rational(2)), Error);
  EXPECT_THROW(region.add_vertex(Decimal{1, 0}, Decimal{2, 0}), Error);
}

TEST(Region, ResultsCarryOriginsAndCopiesKeepThem) {
  Region region = open_ring();
  const EdgeOrigin origin{Operand::kSecond, 3, 4};
  RegionAccess::append_limbs(region, std::array<std::uint64_t, 2>{5, 3});
  RegionAccess::add_vertex(region, {0, 0, 0, 1 | kNegativeLimbs, 1}, {7, 1, 0, 0, 0}, origin);
  EXPECT_TRUE(region.has_origins());
  EXPECT_EQ(region.origin(0), origin);
  EXPECT_EQ(region.exact_x(0), Rational(-5, 3));
  EXPECT_EQ(region.exact_y(0), Rational(14));
  EXPECT_EQ(region.x(0), -5.0 / 3.0);
  const Region copy = region;  // NOLINT(performance-unnecessary-copy-initialization)
  EXPECT_EQ(copy, region);
  region.clear();
  EXPECT_TRUE(region.empty());
  EXPECT_EQ(region.polygon_count(), 0U);
  EXPECT_EQ(copy.exact_x(0), Rational(-5, 3));
}

// A region that was moved from is empty and can be built anew.
TEST(Region, Moves) {
  const Region two = test::make_region(
      {{{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {1, 2}, {2, 1}}}, {{{9, 9}, {12, 9}, {9, 12}}}});
  Region from = two;
  const Region to = std::move(from);
  EXPECT_EQ(to, two);
  EXPECT_TRUE(from == Region());  // NOLINT(bugprone-use-after-move)
  Region other = test::rectangle(0, 0, 1, 1);
  from = std::move(other);
  EXPECT_EQ(from, test::rectangle(0, 0, 1, 1));
  EXPECT_EQ(other.polygon_count() + other.ring_count(), 0U);  // NOLINT(bugprone-use-after-move)
  other.begin_polygon();
  other.begin_ring();
  for (const auto& [x, y] : test::Outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    other.add_vertex(x, y);
  }
  EXPECT_EQ(other, from);
  Region& same = from;
  from = std::move(same);
  EXPECT_EQ(from.polygon_count() + from.ring_count(), from.vertex_count());
}

// The same holds for a geometry.
TEST(Region, MovesWithThinParts) {
  const Geometry all(test::rectangle(0, 0, 1, 1), {{{2, 2}, {3, 5}}}, {{9, 9}});
  Geometry from = all;
  Geometry to = std::move(from);
  EXPECT_EQ(to, all);
  EXPECT_EQ(from, Geometry());  // NOLINT(bugprone-use-after-move)
  from = std::move(to);
  EXPECT_EQ(from, all);
  EXPECT_EQ(to, Geometry());  // NOLINT(bugprone-use-after-move)
}

Region with_origins() {
  Region region = open_ring();
  RegionAccess::append_limbs(region, std::array<std::uint64_t, 2>{5, 3});
  RegionAccess::add_vertex(region, {0, 0, 0, 1, 1}, {7, 1, 0, 0, 0}, {Operand::kSecond, 3, 4});
  RegionAccess::add_vertex(region, {8, 0, 0, 0, 0}, {9, 0, 0, 0, 0}, {Operand::kFirst, 5, 6});
  return region;
}

// Copies share their memory until one of them is changed in any way.
TEST(Region, ChangesOfACopyAreItsOwn) {
  const Region region = with_origins();
  const auto expect_unchanged = [&] {
    EXPECT_EQ(region, with_origins());
    EXPECT_EQ(region.polygon_count(), 1U);
    EXPECT_TRUE(region.has_origins());
    EXPECT_EQ(region.origin(0), (EdgeOrigin{Operand::kSecond, 3, 4}));
    EXPECT_EQ(region.exact_x(0), Rational(5, 3));
  };
  Region grown = region;
  EXPECT_EQ(&grown.origin(0), &region.origin(0));
  grown.add_vertex(Rational(1, 7), Rational(2, 7));
  expect_unchanged();
  EXPECT_EQ(grown.vertex_count(), 3U);
  EXPECT_EQ(grown.exact_x(0), Rational(5, 3));
  EXPECT_EQ(grown.exact_y(2), Rational(2, 7));
  EXPECT_FALSE(grown.has_origins());

  Region exchanged = region;
  RegionAccess::exchange_operands(exchanged);
  expect_unchanged();
  EXPECT_EQ(exchanged.origin(0), (EdgeOrigin{Operand::kFirst, 3, 4}));
  EXPECT_EQ(exchanged, region);

  Region shorter = region;
  RegionAccess::keep_vertices(shorter, 1);
  expect_unchanged();
  EXPECT_EQ(shorter.vertex_count(), 1U);
  EXPECT_TRUE(shorter.has_origins());

  Region without = region;
  RegionAccess::clear_origins(without);
  expect_unchanged();
  EXPECT_FALSE(without.has_origins());
  EXPECT_EQ(without, region);

  Region more_polygons = region;
  more_polygons.begin_polygon();
  more_polygons.begin_ring();
  expect_unchanged();
  EXPECT_EQ(more_polygons.ring_count(), 2U);

  Region cleared = region;
  cleared.clear();
  expect_unchanged();
  EXPECT_EQ(cleared, Region());

  Region moved = region;
  const Region kept = std::move(moved);
  Region assigned = grown;
  assigned = kept;
  assigned = region;
  Region& itself = assigned;
  assigned = itself;
  EXPECT_EQ(assigned, region);
  expect_unchanged();
}

TEST(Region, CopiesAreForDifferentThreads) {
  MINKSUM_NEEDS_THREADS();
  const Region region = with_origins();
  const auto copy_and_change = [copy = region]() mutable {
    for (int i = 0; i < 1000; ++i) {
      const Region shared = copy;
      Region changed = shared;
      changed.add_vertex(i, i);
      if (i % 3 == 0) copy = std::move(changed);
    }
    return copy.vertex_count();
  };
  auto first = std::async(std::launch::async, copy_and_change);
  auto second = std::async(std::launch::async, copy_and_change);
  EXPECT_EQ(first.get(), 336U);
  EXPECT_EQ(second.get(), 336U);
  EXPECT_EQ(region, with_origins());
}

// The arrays lie in one block, where short ones may grow step by step beside long ones.
TEST(Region, GrowsInAnyOrder) {
  Region region;
  test::Random random(5);
  std::vector<std::pair<std::int64_t, Rational>> added;
  for (int polygon = 0; polygon < 40; ++polygon) {
    region.begin_polygon();
    for (std::uint64_t ring = random.next() % 3 + 1; ring > 0; --ring) {
      region.begin_ring();
      for (std::uint64_t v = random.next() % 9; v > 0; --v) {
        const auto x = static_cast<std::int64_t>(random.next() >> 2U);
        const Rational y(static_cast<std::int64_t>(random.next() >> 1U), 7);
        region.add_vertex(Rational(x), y);
        added.emplace_back(x, y);
      }
    }
  }
  EXPECT_EQ(region.polygon_count(), 40U);
  ASSERT_EQ(region.vertex_count(), added.size());
  std::size_t in_rings = 0;
  for (const std::size_t polygon : region.polygons()) {
    for (const std::size_t ring : region.rings_of(polygon)) {
      for (const std::size_t v : region.vertices_of(ring)) EXPECT_EQ(v, in_rings++);
    }
  }
  EXPECT_EQ(in_rings, added.size());
  for (std::size_t v = 0; v < added.size(); ++v) {
    EXPECT_EQ(region.exact_x(v), Rational(added[v].first));
    EXPECT_EQ(region.exact_y(v), added[v].second);
  }
}

}  // namespace
}  // namespace minksum

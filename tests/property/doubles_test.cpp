// Tests that doubles mean exactly themselves, and are as exact as decimals and fractions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "property/provenance.hpp"
#include "property/sums.hpp"
#include "reference/brute_force.hpp"
#include "reference/validity.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr std::uint64_t kDoubleCases = 400;

// Returns a double with a random mantissa and an exponent from -20 to 20.
double random_double(Random& random) {
  const double mantissa = std::ldexp(static_cast<double>(random.next() >> 11U), -53) + 1.0;
  const double value = std::ldexp(mantissa, random.between(-20, 20));
  return random.one_in(2) ? value : -value;
}

using Doubles = std::vector<std::pair<double, double>>;

Region from_doubles(const Doubles& points) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : points) region.add_vertex(x, y);
  return region;
}

Region from_rationals(const Doubles& points) {
  Region region;
  region.begin_polygon();
  region.begin_ring();
  for (const auto& [x, y] : points) region.add_vertex(Rational(x), Rational(y));
  return region;
}

// Returns three to five random points in an order that makes a simple ring.
Doubles random_outline(Random& random) {
  for (;;) {
    Doubles points;
    for (int n = random.between(3, 5); n > 0; --n) {
      const double x = random_double(random);
      points.emplace_back(x, random_double(random));
    }
    std::sort(points.begin() + 1, points.end());
    do {
      if (reference::validity_fault(from_rationals(points)).empty()) return points;
    } while (std::next_permutation(points.begin() + 1, points.end()));
  }
}

TEST(Doubles, SumsAreExact) {
  for (std::uint64_t seed = 1; seed <= kDoubleCases && !HasFailure(); ++seed) {
    Random random(seed);
    const Doubles a = random_outline(random);
    const Doubles b = random_outline(random);
    const Region p = from_doubles(a);
    const Region q = from_doubles(b);
    SCOPED_TRACE(note(seed, p, q));
    ASSERT_EQ(p, from_rationals(a));
    const Region sum = minkowski_sum(p, q);
    EXPECT_EQ(sum, reference::brute_force_sum(p, q));
    EXPECT_EQ(sum, minkowski_sum(from_rationals(a), from_rationals(b)));
    EXPECT_EQ(sum, sum_by(Method::kSigned, p, q));
    EXPECT_EQ(provenance_fault(p, q, sum), "");
    EXPECT_EQ(reference::canonical_fault(sum), "");
  }
}

TEST(Doubles, OneExponentWithFullMantissas) {
  for (std::uint64_t seed = 1; seed <= kDoubleCases && !HasFailure(); ++seed) {
    Random random(seed);
    const int exponent = random.between(-20, 20);
    const auto jittered = [&](const Region& region) {
      Doubles points;
      for (const std::size_t v : region.vertices_of(0)) {
        const auto noise = [&] {
          return std::ldexp(static_cast<double>(random.below(1 << 20)), -30);
        };
        const double x = std::ldexp(region.x(v) + noise(), exponent);
        points.emplace_back(x, std::ldexp(region.y(v) + noise(), exponent));
      }
      return points;
    };
    const Region p = from_doubles(jittered(random_star_shaped(random, 8, 24)));
    const Region q = from_doubles(jittered(random_star_shaped(random, 8, 24)));
    if (!reference::validity_fault(p).empty() || !reference::validity_fault(q).empty()) continue;
    SCOPED_TRACE(note(seed, p, q));
    EXPECT_EQ(minkowski_sum(p, q), reference::brute_force_sum(p, q));
  }
}

TEST(Doubles, DecimalsAreNotDoubles) {
  const auto triangle = [](auto tenth, auto zero) {
    Region region;
    region.begin_polygon();
    region.begin_ring();
    region.add_vertex(zero, zero);
    region.add_vertex(tenth, zero);
    region.add_vertex(zero, tenth);
    return region;
  };
  const Region decimals = triangle(Decimal{1, -1}, Decimal{0, 0});
  const Region doubles = triangle(0.1, 0.0);
  EXPECT_NE(decimals, doubles);
  EXPECT_EQ(minkowski_sum(decimals, decimals), triangle(Rational(1, 5), Rational(0)));
  EXPECT_EQ(minkowski_sum(doubles, doubles), triangle(0.2, 0.0));
  EXPECT_EQ(minkowski_sum(doubles, decimals),
            triangle(Rational(0.1) + Rational(1, 10), Rational(0)));
}

TEST(Doubles, DecimalsFractionsAndDoublesMix) {
  for (std::uint64_t seed = 1; seed <= kDoubleCases && !HasFailure(); ++seed) {
    Random random(seed);
    const Pair pair = random_pair(random);
    const Region decimals = scaled(pair.p, Rational(Decimal{1, -random.between(1, 9)}));
    const Region fractions = scaled(pair.q, Rational(1, random.between(1, 999)));
    SCOPED_TRACE(note(seed, decimals, fractions));
    EXPECT_EQ(minkowski_sum(decimals, fractions), reference::brute_force_sum(decimals, fractions));
    const Region binary = scaled(pair.q, Rational(std::ldexp(1.0, random.between(-20, 20))));
    EXPECT_EQ(minkowski_sum(decimals, binary), reference::brute_force_sum(decimals, binary));
  }
}

}  // namespace

// Compares sums of small operands, which take a shorter way, with those by the stages.
// MINKSUM_PAIRS is the number of pairs, MINKSUM_SEED the first seed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "minksum/boolean.hpp"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/transform.hpp"
#include "minksum/validity.hpp"
#include "property/provenance.hpp"
#include "property/sums.hpp"
#include "support/polygon_kinds.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr int kDefaultPairs = 10'000;

Region random_shape(Random& random) {
  switch (random.below(16)) {
    case 0:
      return random_two_opt(random, random.between(4, 16), random.between(5, 12));
    case 1:
      return random_two_opt(random, random.between(4, 14), random.between(100, 60'000));
    case 2:
      return random_star_shaped(random, random.between(4, 16), random.between(5, 40));
    case 3:
      return random_convex(random, random.between(3, 20), random.between(8, 1'000));
    case 4:
      return random_cells(random, random.between(2, 4), random.between(2, 4), random.one_in(2),
                          true);
    case 5:
      return comb(random.between(2, 7), random.between(1, 3), random.between(1, 9));
    case 6:
      return spiral(random.between(1, 4));
    case 7:
      return random_triangle(random, random.between(1, 20));
    // So many vertices make hundreds of segments.
    case 8:
      return random_two_opt(random, random.between(16, 40), random.between(30, 400));
    case 9:
      return round_polygon(random.between(8, 100), random.between(200, 5'000));
    case 10:
      return comb(random.between(8, 30), random.between(1, 3), random.between(1, 9));
    // The shapes are so wide that doubles do not hold cross products.
    case 11:
      return random_two_opt(random, random.between(4, 16),
                            random.between(30'000'000, 1'000'000'000));
    case 12:
      return random_star_shaped(random, random.between(40, 120), random.between(500, 20'000));
    case 13:
      return random_two_opt(random, random.between(40, 70), random.between(2'000, 60'000));
    // The other operand may fit into the holes or not.
    case 14:
      return random_with_holes(random, random.between(6, 40), random.between(1, 4));
    default:
      return random_polygon(random);
  }
}

/// Returns some polygons side by side, which may touch, and perhaps another one around them. Or
/// returns a box without them.
Region random_polygons(Random& random) {
  Region all;
  Rational left = 0;
  for (int k = random.between(2, 4); k > 0; --k) {
    const Region shape = random_shape(random);
    const Box box = *bounding_box(shape);
    const Rational gap = random.between(0, 8);
    const Affine map = Affine::translation(left + gap - box.min.x, random.between(-9, 9));
    const Region more = all.empty() ? transform(shape, map) : together(all, transform(shape, map));
    if (!validate(more).empty()) continue;  // edges overlap
    all = more;
    left = bounding_box(all)->max.x;
  }
  if (random.one_in(2)) return all;
  const auto ring_around = [box = *bounding_box(all)](const Rational& by) {
    const auto& [low, high] = box;
    return Ring{{low.x - by, low.y - by},
                {high.x + by, low.y - by},
                {high.x + by, high.y + by},
                {low.x - by, high.y + by}};
  };
  const Rational gap = random.between(1, 20);
  if (random.one_in(2)) return subtract(Region(Polygon{ring_around(gap), {}}), all);
  return together(all, Region(Polygon{ring_around(gap + 2), {ring_around(gap)}}));
}

/// Returns a ring with waves and notches. A cover hides much of the sum of two of these.
Region random_outline(Random& random, int vertices) {
  const int waves = random.between(2, 9);
  const int depth = random.between(1, 40);
  const int notches = random.between(0, 2'000);
  Outline outline;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices;
    const double radius =
        1e6 * (1 + depth / 100.0 * std::sin(waves * angle)) + random.between(-notches, notches);
    outline.push_back(
        {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  return make_polygon(outline);
}

/// Returns a number of many digits, decimal or binary. On a common grid of both kinds, coordinates
/// have more than 125 bits.
Rational random_fraction(Random& random) {
  const auto digits = static_cast<std::int64_t>(random.next() >> 5U | 1U);
  const std::int64_t step =
      random.one_in(2) ? std::int64_t{1} << 58U : std::int64_t{1'000'000'000'000'000'000};
  return Rational(digits, step);
}

/// Returns a map that turns, mirrors, moves and changes the grid.
Affine random_map(Random& random) {
  const auto power = [&](std::int64_t base, int most) {
    Rational value = 1;
    for (int k = random.below(most); k > 0; --k) value = value * base;
    return random.one_in(2) ? value : Rational(1) / value;
  };
  const Rational scale = random.one_in(2)   ? Rational(1)
                         : random.one_in(4) ? random_fraction(random)
                                            : power(10, 4) * power(2, 5);
  Affine map = Affine::quarter_turns(random.below(4));
  if (random.one_in(4)) map = Affine{-1, 0, 0, 0, 1, 0}.after(map);
  map = Affine::scaling(scale).after(map);
  if (random.one_in(3)) return map;
  const auto far = [&] {
    return Rational(static_cast<std::int64_t>(random.next() >> 6U) - (std::int64_t{1} << 57U));
  };
  const auto near = [&] { return Rational(random.between(-99, 99)); };
  const bool is_far = random.one_in(8);
  const Rational dx = is_far ? far() : near();
  const Rational dy = is_far ? far() : near();
  return Affine::translation(dx * scale, dy * scale).after(map);
}

/// Returns a map that makes all directions nearly equal. It changes no cross product, but the
/// products that it is the difference of grow far beyond it.
Affine random_shear(Random& random) {
  const auto steep = [&] { return Rational(std::int64_t{1} << random.between(8, 20)); };
  return Affine{1, 0, 0, steep(), 1, 0}.after(Affine{1, steep(), 0, 0, 1, 0});
}

/// Returns a region turned by an angle, in doubles that round it. So its numbers are long, and
/// edges that were parallel to an axis or to each other nearly are. If that is no valid region,
/// nothing changes.
Region turned_in_doubles(const Region& region, Random& random) {
  const double degrees = random.one_in(3) ? 90 * random.below(4) : random.between(0, 3600) / 10.0;
  const double turn = degrees * std::numbers::pi / 180;
  const double scale = random.one_in(2) ? 1 : random.between(1, 999) / 1000.0;
  Region turned;
  for (std::size_t polygon = 0; polygon < region.polygon_count(); ++polygon) {
    turned.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      turned.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        const double x = scale * region.x(v);
        const double y = scale * region.y(v);
        turned.add_vertex(std::cos(turn) * x - std::sin(turn) * y,
                          std::sin(turn) * x + std::cos(turn) * y);
      }
    }
  }
  return validate(turned).empty() ? turned : region;
}

bool have_equal_origins(const Region& a, const Region& b) {
  if (a.has_origins() != b.has_origins()) return false;
  for (std::size_t v = 0; a.has_origins() && v < a.vertex_count(); ++v) {
    if (a.origin(v) != b.origin(v)) return false;
  }
  return true;
}

/// Compares a random pair's sums, and returns whether it was small.
bool compare(std::uint64_t seed) {
  Random random(seed);
  Region p = transform(random_shape(random), random_map(random));
  Region q = random.one_in(4) ? transform(p, Affine::quarter_turns(random.below(4)))
                              : transform(random_shape(random), random_map(random));
  // So many vertices take several words of blocks.
  if (p.vertex_count() <= 12 && random.one_in(300)) {
    q = transform(
        random_star_shaped(random, random.between(300, 1'200), random.between(5'000, 900'000)),
        random_map(random));
  }
  if (random.one_in(100)) {
    const Affine smaller = Affine::scaling(Rational(1, random.between(1, 40)));
    p = transform(random_outline(random, random.between(8, 150)), random_map(random));
    q = transform(random_outline(random, random.between(200, 900)),
                  random_map(random).after(smaller));
  }
  if (random.one_in(8)) (random.one_in(2) ? p : q) = random_polygons(random);
  if (random.one_in(3)) {
    const Affine shear = random_shear(random);
    p = transform(p, shear);
    q = transform(q, shear);
  }
  if (random.one_in(4)) p = turned_in_doubles(p, random);
  if (random.one_in(4)) q = turned_in_doubles(q, random);
  if (random.one_in(4)) p = scrambled(p, random);
  const DetailedSum detailed = detailed_sum(p, q);
  const Region& sum = detailed.sum.region;
  const bool small = detailed.statistics.small;
  // A pair that is not small takes the stages anyway. Comparing such pairs would take most of the
  // time, and shows only that prepared operands give the same sum.
  if (!small && seed % 8 != 0) return false;
  EXPECT_EQ(to_text(sum), to_text(sum_by_stages(p, q))) << note(seed, p, q);
  // Prepared operands are validated on their own, and brought to one grid as copies.
  const Region of_prepared = minkowski_sum(PreparedRegion(p), PreparedRegion(q));
  EXPECT_EQ(to_text(of_prepared), to_text(sum)) << note(seed, p, q);
  if (seed % 8 == 0) {
    EXPECT_EQ(provenance_fault(p, q, sum), "") << note(seed, p, q);
    // Checking takes long. Equal regions with equal origins are checked once.
    if (!have_equal_origins(of_prepared, sum)) {
      EXPECT_EQ(provenance_fault(p, q, of_prepared), "") << note(seed, p, q);
    }
  }
  return small;
}

TEST(SmallSums, AreAsByTheStages) {
  const std::uint64_t first = seed_from_environment(1);
  const auto count = static_cast<std::uint64_t>(count_from_environment(kDefaultPairs));
  std::uint64_t small = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
    if (compare(seed)) ++small;
  }
  if (count >= 1'000 && !HasFailure()) {
    EXPECT_GT(4 * small, 3 * count);
  }
}

}  // namespace

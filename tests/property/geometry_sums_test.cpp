// Tests sums of geometries with thin parts: all methods against brute force on small random pairs,
// all settings, and known results. MINKSUM_PAIRS is the number of pairs, MINKSUM_SEED the first
// seed.
#include <gtest/gtest.h>

#include <exception>
#include <iostream>

#include "minksum/minkowski_sum.hpp"
#include "minksum/testing.hpp"
#include "reference/brute_force.hpp"
#include "reference/brute_force_overlay.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr int kDefaultPairs = 1000;

struct GeometryPair {
  std::string kind;
  Geometry p;
  Geometry q;
};

std::string note(std::uint64_t seed, const GeometryPair& pair) {
  return pair.kind + ", seed " + std::to_string(seed) + "\nP " + to_text(pair.p) + "\nQ " +
         to_text(pair.q);
}

/// Returns random rings that cross, run back over themselves, and collapse.
Region random_rings(Random& random, int size) {
  Region region;
  for (int polygons = random.between(1, 2); polygons > 0; --polygons) {
    region.begin_polygon();
    for (int rings = random.between(1, 2); rings > 0; --rings) {
      region.begin_ring();
      for (int i = random.between(1, 6); i > 0; --i) {
        region.add_vertex(random.between(0, size), random.between(0, size));
      }
    }
  }
  return region;
}

/// Returns a random operand. Half of all operands are on tiny grids, where edges are parallel and
/// meet.
Geometry random_operand(Random& random, std::string& kind) {
  const int size = random.one_in(2) ? 3 : 12;
  switch (random.below(6)) {
    case 0:
      kind += "region";
      return {random_region(random), {}, {}};
    case 1:
      kind += "polyline";
      return {{}, {random_simple_polyline(random, random.between(1, 5), size)}, {}};
    case 2:
      kind += "thin";
      return random_thin(random, size);
    case 3:
      kind += "rings";
      return {random_rings(random, size), {}, {}};
    default: {
      kind += "mixed";
      Geometry mixed = random_thin(random, size);
      mixed.region = random_polygon(random);
      return mixed;
    }
  }
}

GeometryPair random_geometry_pair(Random& random) {
  GeometryPair pair;
  pair.p = random_operand(random, pair.kind);
  pair.kind += " and ";
  pair.q = random_operand(random, pair.kind);
  if (random.one_in(4)) pair.q = scaled(pair.q, Rational(1, random.between(2, 9)));
  return pair;
}

Geometry sum_by(Method method, const GeometryPair& pair) {
  SumSettings options;
  options.method = method;
  return minkowski_sum(pair.p, pair.q, options);
}

TEST(RandomGeometries, ReducedIsSignedIsBruteForce) {
  const std::uint64_t first = seed_from_environment(1);
  const int count = count_from_environment(kDefaultPairs);
  int failed = 0;
  int with_region = 0;
  int with_holes = 0;
  int thin = 0;
  for (int i = 0; i < count && failed < 5; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    Random random(seed);
    const GeometryPair pair = random_geometry_pair(random);
    try {
      const Geometry truth = reference::brute_force_sum(
          reference::brute_force_resolve(pair.p, FillRule::kAutomatic),
          reference::brute_force_resolve(pair.q, FillRule::kAutomatic));
      with_region += truth.region.empty() ? 0 : 1;
      with_holes += truth.region.hole_count() > 0 ? 1 : 0;
      thin += truth.has_thin_parts() ? 1 : 0;
      const std::string expected = to_text(truth);
      const std::string reduced = to_text(sum_by(Method::kReduced, pair));
      const std::string by_winding = to_text(sum_by(Method::kSigned, pair));
      const std::string full = i % 4 == 0 ? to_text(sum_by(Method::kFull, pair)) : expected;
      EXPECT_EQ(reduced, expected) << "reduced; " << note(seed, pair);
      EXPECT_EQ(by_winding, expected) << "signed; " << note(seed, pair);
      EXPECT_EQ(full, expected) << "full; " << note(seed, pair);
      failed += reduced != expected || by_winding != expected || full != expected ? 1 : 0;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "; " << note(seed, pair);
      ++failed;
    }
  }
  std::cout << count << " pairs from seed " << first << "; sums with area: " << with_region
            << ", with holes: " << with_holes << ", with thin parts: " << thin << '\n';
}

/// Returns a simple zigzag on integers, which goes up, down and forth.
Polyline zigzag(Random& random, int edges, int height, int step) {
  Outline vertices;
  for (int i = 0; i <= edges; ++i) {
    vertices.push_back({i * step, random.between(0, height / 3) + (i % 2 != 0 ? height : 0)});
  }
  return make_polyline(vertices);
}

struct Setting {
  std::string name;
  SumSettings options;
};

Setting setting(const char* name, void (*change)(SumSettings&)) {
  Setting result{name, {}};
  change(result.options);
  return result;
}

std::vector<Setting> settings() {
  return {setting("cover off", [](SumSettings& o) { o.cover = false; }),
          setting("grid 256", [](SumSettings& o) { o.grid = 256; }),
          setting("wide", [](SumSettings& o) { o.arithmetic = Arithmetic::kWide; })};
}
/// Returns settings that take long with many segments.
std::vector<Setting> slow_settings() {
  return {setting("grid 16", [](SumSettings& o) { o.grid = 16; }),
          setting("filter off", [](SumSettings& o) { o.filter = false; }),
          setting("medium", [](SumSettings& o) { o.arithmetic = Arithmetic::kMedium; }),
          setting("arbitrary", [](SumSettings& o) { o.arithmetic = Arithmetic::kArbitrary; }),
          setting("signed", [](SumSettings& o) { o.method = Method::kSigned; }),
          setting("checked", [](SumSettings& o) { o.check = true; }),
          setting("full", [](SumSettings& o) { o.method = Method::kFull; })};
}

void expect_same(const GeometryPair& pair, const std::vector<Setting>& all,
                 const std::string& about) {
  const std::string expected = to_text(sum_by(Method::kReduced, pair));
  EXPECT_EQ(to_text(minkowski_sum(pair.q, pair.p)), expected) << about << ", exchanged";
  for (const auto& [name, options] : all) {
    const Geometry sum = minkowski_sum(pair.p, pair.q, options);
    EXPECT_EQ(to_text(sum), expected) << about << ", " << name;
  }
}

TEST(GeometrySettings, GiveTheSameBytes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const GeometryPair pair = random_geometry_pair(random);
    expect_same(pair, settings(), note(seed, pair));
    expect_same(pair, slow_settings(), note(seed, pair));
  }
}

// The operands are large enough for covers by translates and by winding number.
TEST(GeometrySettings, GiveTheSameBytesWithManySegments) {
  Random random(7);
  const Geometry star{spiky_star(random, 16, 2000), {}, {}};
  const Geometry framed{frame({{{0, 0}, {900, 100}, {700, 800}, {100, 600}}}, 300), {}, {}};
  const Geometry zig{{}, {zigzag(random, 16, 1500, 60), zigzag(random, 5, 900, 400)}, {}};
  const Geometry hedge{{}, {zigzag(random, 24, 3000, 11)}, {}};
  expect_same({"", star, zig}, settings(), "star and zigzag");
  expect_same({"", star, hedge}, settings(), "star and hedge");
  expect_same({"", framed, hedge}, settings(), "frame and hedge");
  const Geometry small{{}, {zigzag(random, 5, 90, 20)}, {}};
  expect_same({"", framed, small}, settings(), "frame and a small zigzag");
  expect_same({"", hedge, zig}, settings(), "hedge and zigzag");
}

}  // namespace

// Tests tight places against brute force on many small pairs that fit tightly. MINKSUM_PAIRS is the
// number of pairs, MINKSUM_SEED the first seed.
#include <gtest/gtest.h>

#include <exception>
#include <iostream>
#include <vector>

#include "property/sums.hpp"
#include "reference/brute_force.hpp"
#include "reference/brute_force_overlay.hpp"
#include "reference/convex_pieces.hpp"
#include "reference/tight_places.hpp"
#include "reference/validity.hpp"
#include "support/degenerate_pairs.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr int kDefaultPairs = 3000;
constexpr int kMaxFailures = 5;

std::string text_of(const Geometry& tight) {
  std::string text;
  const auto add = [&](const std::vector<Point>& points) {
    text += " (";
    for (const Point& p : points) text += p.x.to_string() + ' ' + p.y.to_string() + ',';
    text.back() = ')';
  };
  for (const Polyline& line : tight.polylines) add(line);
  for (const Point& point : tight.points) add({point});
  return text;
}

// Returns a box of cells without some of them, which leaves slots, rooms and corridors.
Region carved(Random& random, bool halves) {
  const int columns = random.between(3, 5);
  const int rows = random.between(3, 5);
  const Region cells = random_cells(random, columns, rows, halves, random.one_in(2));
  if (!random.one_in(3)) return cells;
  std::vector<Outline> holes;
  for (const std::size_t p : cells.polygons()) {
    Outline& hole = holes.emplace_back();
    for (const std::size_t v : cells.vertices_of(cells.rings_of(p).front())) {
      hole.push_back(
          {static_cast<std::int64_t>(cells.x(v)), static_cast<std::int64_t>(cells.y(v))});
    }
  }
  const Region around = frame(holes, 1);
  return reference::validity_fault(around).empty() ? around : cells;
}

Region small_part(Random& random) {
  switch (random.below(6)) {
    case 0:
      return rectangle(0, 0, random.between(1, 2), random.between(1, 3));
    case 1:
      return make_polygon({{0, 0}, {1, 0}, {0, 1}});
    case 2:
      return make_polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}});
    case 3:
      return random_triangle(random, 3);
    default:
      return random_cells(random, random.between(1, 3), random.between(1, 3), random.one_in(2),
                          random.one_in(2));
  }
}

// Returns a convex part and a hole in which it can move along one path.
Pair part_and_slot(Random& random) {
  const Region part = random_convex(random, random.between(3, 6), 4);
  const std::int64_t dx = random.between(-4, 4);
  const std::int64_t dy = random.between(0, 4);
  reference::IntLoop<std::int64_t> swept;
  for (const std::size_t v : part.vertices_of(0)) {
    const auto x = -static_cast<std::int64_t>(part.x(v));
    const auto y = -static_cast<std::int64_t>(part.y(v));
    swept.insert(swept.end(), {{x, y}, {x + dx, y + dy}});
  }
  Outline hole;
  for (const auto& [x, y] : reference::convex_hull(swept)) hole.push_back({x, y});
  return {frame({hole}, random.between(1, 2)), part, "part and slot"};
}

// Returns a part and a hole of its form.
Pair part_and_frame(Random& random) {
  Region part = random.one_in(2) ? small_part(random) : random_polygon(random);
  if (part.ring_count() != 1) part = rectangle(0, 0, random.between(1, 3), random.between(1, 3));
  Outline hole;
  for (const std::size_t v : part.vertices_of(0)) {
    hole.push_back({-static_cast<std::int64_t>(part.x(v)), -static_cast<std::int64_t>(part.y(v))});
  }
  return {frame({hole}, random.between(1, 2)), part, "frame and part"};
}

Pair tight_pair(Random& random) {
  Pair pair;
  const bool halves = random.one_in(2);
  switch (random.below(11)) {
    case 0:
      pair = random_pair(random);
      return pair;
    case 4:
    case 5:
      pair = {lace(random), lace(random), "lace and lace"};
      break;
    case 6:
      pair = {lace(random), small_part(random), "lace and part"};
      break;
    case 7:
      pair = part_and_frame(random);
      break;
    case 8:
      pair = part_and_slot(random);
      break;
    case 1:
      pair = {comb(random.between(2, 3), random.between(1, 2), random.between(1, 4)),
              small_part(random), "comb and part"};
      break;
    case 2:
      pair = {carved(random, halves), carved(random, halves), "cells and cells"};
      break;
    case 3:
      pair = {spiral(random.between(1, 2)), small_part(random), "spiral and part"};
      break;
    default:
      pair = {carved(random, halves), small_part(random), "cells and part"};
  }
  if (random.one_in(2)) pair.q = scaled(pair.q, -1);
  if (random.one_in(8)) pair.q = scaled(pair.q, Rational(1, 2));
  if (random.one_in(4)) pair.q = scrambled(scaled(pair.q, 4), random), pair.p = scaled(pair.p, 4);
  if (random.one_in(2)) std::swap(pair.p, pair.q);
  return pair;
}

struct Tally {
  int with_points = 0;
  int with_lines = 0;
  int with_both = 0;
  void count(const Geometry& tight) {
    with_points += tight.points.empty() ? 0 : 1;
    with_lines += tight.polylines.empty() ? 0 : 1;
    with_both += tight.points.empty() || tight.polylines.empty() ? 0 : 1;
  }
};

Geometry tight_places(const Region& p, const Region& q, SumSettings options, const Region& expected,
                      const std::string& about) {
  options.tight = true;
  DetailedSum found = detailed_sum(p, q, options);
  EXPECT_EQ(found.sum.region, expected) << about;
  return std::move(found.tight);
}

void compare(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const Pair pair = tight_pair(random);
  const Geometry truth = reference::brute_force_tight_places(pair.p, pair.q);
  tally.count(truth);
  const Region sum = minkowski_sum(pair.p, pair.q);
  if (seed % 16 == 0) {
    EXPECT_EQ(to_text(sum), to_text(reference::brute_force_sum(pair.p, pair.q)));
  }
  SumSettings options;
  options.check = seed % 8 == 0;
  switch (seed % 5) {
    case 1:
      options.cover = false;
      break;
    case 2:
      options.grid = random.between(2, 40);
      break;
    case 3:
      options.arithmetic = seed % 2 == 0 ? Arithmetic::kArbitrary : Arithmetic::kWide;
      break;
    default:
      break;
  }
  options.filter = seed % 32 != 5;
  const Geometry tight = tight_places(pair.p, pair.q, options, sum, note(seed, pair));
  EXPECT_EQ(text_of(tight), text_of(truth)) << note(seed, pair);
}

TEST(RandomTightPairs, AgreeWithBruteForce) {
  const std::uint64_t first = seed_from_environment(1);
  const auto count = static_cast<std::uint64_t>(count_from_environment(kDefaultPairs));
  int failures = 0;
  Tally tally;
  std::uint64_t done = 0;
  for (; done < count && failures < kMaxFailures; ++done) {
    try {
      compare(first + done, tally);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "; seed " << first + done;
    }
    if (::testing::Test::HasFailure()) ++failures;
  }
  std::cout << done << " pairs from seed " << first << "; with tight points: " << tally.with_points
            << ", lines: " << tally.with_lines << ", both: " << tally.with_both << '\n';
}

Geometry with_walls(const Region& region, Random& random) {
  Geometry result{region, {}, {}};
  for (int walls = random.between(0, 2); walls > 0; --walls) {
    Polyline& wall = result.polylines.emplace_back();
    for (int i = random.between(2, 3); i > 0; --i) {
      wall.push_back({random.between(-2, 8), random.between(-2, 8)});
    }
  }
  if (random.one_in(4)) result.points.push_back({random.between(-2, 8), random.between(-2, 8)});
  return reference::brute_force_resolve(result, FillRule::kAutomatic);
}

/// Returns the tight places of both areas without what sums with thin parts cover, resolved.
Geometry uncovered_tight_places(const Geometry& p, const Geometry& q) {
  const Geometry thin_p{{}, p.polylines, p.points};
  const Geometry thin_q{{}, q.polylines, q.points};
  const std::vector<Geometry> sums{reference::brute_force_sum(thin_p, q),
                                   reference::brute_force_sum(p, thin_q)};
  const Region cover = reference::brute_force_unite(sums).region;
  const std::vector<Geometry> both{{cover, {}, {}},
                                   reference::brute_force_tight_places(p.region, q.region)};
  const Geometry left = reference::brute_force_unite(both);
  return reference::brute_force_resolve({{}, left.polylines, left.points}, FillRule::kAutomatic);
}

TEST(TightPairsWithWalls, AgreeWithBruteForce) {
  Tally tally;
  const int count = count_from_environment(kDefaultPairs) / 20;
  const std::uint64_t first = seed_from_environment(1);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    Random random(seed * 104729);
    const Pair pair = tight_pair(random);
    const Geometry p = with_walls(pair.p, random);
    const Geometry q = with_walls(pair.q, random);
    const Geometry tight = detailed_sum(p, q, {.tight = true}).tight;
    EXPECT_EQ(to_text(tight), to_text(uncovered_tight_places(p, q))) << "seed " << seed << '\n'
                                                                     << to_text(p) << '\n'
                                                                     << to_text(q);
    tally.count(tight);
  }
  std::cout << count << " pairs with walls; with tight points: " << tally.with_points
            << ", lines: " << tally.with_lines << ", both: " << tally.with_both << '\n';
}

Pair larger_pair(Random& random) {
  switch (random.below(5)) {
    case 0: {
      const int teeth = random.between(4, 10);
      const Region a = comb(teeth, random.between(1, 2), random.between(4, 30));
      return {a, random.one_in(2) ? a : comb(random.between(4, teeth), 1, random.between(4, 30)),
              "combs"};
    }
    case 1:
      return {spiral(random.between(3, 6)), comb(random.between(3, 7), 1, random.between(4, 20)),
              "spiral and comb"};
    case 2:
      return {spiral(random.between(3, 6)), spiral(random.between(2, 5)), "spirals"};
    case 3:
      return {random_cells(random, random.between(7, 11), random.between(7, 11), random.one_in(2),
                           false),
              small_part(random), "cells and part"};
    default:
      return {
          random_cells(random, random.between(5, 8), random.between(5, 8), random.one_in(2), false),
          random_cells(random, random.between(3, 6), random.between(3, 6), random.one_in(2), false),
          "cells and cells"};
  }
}

// The pairs are so large that covers of both kinds hide most segments, which must lose nothing.
TEST(LargerTightPairs, CoverHidesNothing) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    Random random(seed * 7919);
    Pair pair = larger_pair(random);
    if (random.one_in(2)) pair.q = scaled(pair.q, -1);
    if (random.one_in(4)) pair.q = turned(pair.q);
    if (random.one_in(4)) pair.p = scaled(pair.p, 2);
    const std::string about = note(seed * 7919, pair);
    const Region sum = minkowski_sum(pair.p, pair.q);
    SumSettings options;
    options.cover = false;
    const Geometry truth = tight_places(pair.p, pair.q, options, sum, about);
    tally.count(truth);
    options.cover = true;
    for (const int grid : {0, 16, 100, 400}) {
      options.grid = grid;
      options.check = grid == 16 && seed % 10 == 0;
      EXPECT_EQ(text_of(tight_places(pair.p, pair.q, options, sum, about)), text_of(truth))
          << "grid " << grid << ' ' << about;
    }
    // With exchanged operands, other ends of parallel edges count.
    EXPECT_EQ(text_of(tight_places(pair.q, pair.p, {}, sum, about)), text_of(truth)) << about;
  }
  std::cout << "larger pairs with tight points: " << tally.with_points
            << ", lines: " << tally.with_lines << ", both: " << tally.with_both << '\n';
}

}  // namespace

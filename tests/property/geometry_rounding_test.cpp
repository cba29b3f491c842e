// Tests that rounded geometries with thin parts are resolved, on the target, on their side point by
// point, and no farther away than reported.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "reference/boundary_distance.hpp"
#include "reference/brute_force_overlay.hpp"
#include "reference/exact.hpp"
#include "support/generators.hpp"
#include "support/geometries.hpp"
#include "support/geometry_laws.hpp"
#include "support/messes.hpp"
#include "support/rounding_options.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;
using reference::farther_than;

constexpr std::array<std::optional<int>, 3> kTargets = {std::nullopt, 3, 0};

std::vector<Point> random_points(Random& random, int count, int size) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const int x = random.between(0, size);
    points.push_back({Rational(x), Rational(random.between(0, size))});
  }
  return points;
}

/// Returns a random area, paths and points.
Geometry random_parts(Random& random) {
  Geometry geometry;
  const int size = random.between(2, 9);
  if (random.one_in(2)) {
    geometry.region.begin_polygon();
    geometry.region.begin_ring();
    for (const Point& p : random_points(random, random.between(3, 6), size)) {
      geometry.region.add_vertex(p.x, p.y);
    }
  }
  for (int i = random.between(1, 3); i > 0; --i) {
    geometry.polylines.push_back(random_points(random, random.between(2, 4), size));
  }
  geometry.points = random_points(random, random.between(0, 3), size);
  return geometry;
}

/// Returns a resolved geometry, at a scale that makes its features larger or smaller than the steps
/// of rounding.
Geometry random_geometry(Random& random) {
  Geometry geometry;
  switch (random.below(3)) {
    case 0:
      geometry = random_parts(random);
      break;
    case 1:
      geometry = random_mess(random);
      break;
    default:
      geometry = random_mess(random);
      for (Polyline& line : random_thin(random, random.between(1, 6)).polylines) {
        geometry.polylines.push_back(std::move(line));
      }
  }
  if (random.one_in(8)) geometry = transformed(geometry, random_projection(random));
  // Sometimes only crossings have to be rounded.
  if (random.one_in(4)) return resolve(geometry);
  const int above = random.between(1, 40);
  return resolve(scaled(geometry, Rational(above, random.between(1, 40))));
}

/// Returns whether a ⊆ b, by means that share nothing with the library.
bool contains_by_reference(const Geometry& b, const Geometry& a) {
  return reference::brute_force_unite(std::array{a, b}) == b;
}

/// Counts what happened, for the log of a long run.
struct GeometryTally {
  std::uint64_t rounded = 0;
  std::uint64_t exact = 0;
  std::uint64_t snapped = 0;
  std::uint64_t thin = 0;
};

void check(const Geometry& exact, const RoundOptions& options, bool by_reference,
           GeometryTally& tally) {
  RoundingReport report;
  const Geometry rounded = round(exact, options, report);
  ++tally.rounded;
  tally.exact += report.exact ? 1 : 0;
  tally.snapped += report.snapped ? 1 : 0;
  tally.thin += rounded.has_thin_parts() ? 1U : 0U;
  // The result must be on the target, valid, resolved, on its side, and exact if reported so.
  EXPECT_EQ(broken_rounding(exact, options, report, rounded), "");
  EXPECT_EQ(report.exact, rounded == exact);
  if (report.exact) {
    EXPECT_EQ(report.largest_move, 0);
  }
  EXPECT_FALSE(farther_than(report.largest_move, rounded, exact)) << to_text(rounded);
  const Geometry differing{symmetric_difference(rounded.region, exact.region), {}, {}};
  EXPECT_FALSE(farther_than(report.largest_move, differing, exact)) << to_text(rounded);
  if (!by_reference) return;
  EXPECT_EQ(reference::resolved_fault(rounded), "");
  if (options.side == RoundingSide::kOutside) {
    EXPECT_TRUE(contains_by_reference(rounded, exact)) << to_text(rounded);
  }
  if (options.side == RoundingSide::kInside) {
    EXPECT_TRUE(contains_by_reference(exact, rounded)) << to_text(rounded);
  }
}

TEST(GeometryRounding, RandomGeometries) {
  constexpr int kDefaultGeometries = 250;
  constexpr std::uint64_t kReferenceEvery = 8;
  const std::uint64_t first = seed_from_environment(1);
  const auto count = static_cast<std::uint64_t>(count_from_environment(kDefaultGeometries));
  GeometryTally tally;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
    Random random(seed);
    const Geometry exact = random_geometry(random);
    for (const RoundingSide side : kRoundingSides) {
      for (const std::optional<int> decimals : kTargets) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + to_string(side) + ", decimals " +
                     (decimals ? std::to_string(*decimals) : "none") + "\nexact " + to_text(exact));
        check(exact, rounding(decimals, side), seed % kReferenceEvery == 0, tally);
      }
    }
  }
  std::cout << tally.rounded << " rounded, " << tally.exact << " exact, " << tally.snapped
            << " snapped, " << tally.thin << " with thin parts\n";
}

TEST(GeometryRounding, ItsJudgesCanReject) {
  const Geometry square{rectangle(0, 0, 4, 4), {}, {}};
  const Geometry line = make_lines({{{0, 0}, {4, 4}}});
  const Geometry longer = make_lines({{{0, 0}, {5, 5}}});
  const Geometry point = make_lines({}, {{4, 4}});
  for (const Geometry* set : {&square, &line, &longer}) {
    EXPECT_TRUE(contains(*set, point));
    EXPECT_TRUE(contains_by_reference(*set, point));
    EXPECT_FALSE(contains(point, *set));
    EXPECT_FALSE(contains_by_reference(point, *set));
  }
  EXPECT_TRUE(contains(square, line));
  EXPECT_TRUE(contains_by_reference(square, line));
  EXPECT_FALSE(contains(square, longer));
  EXPECT_FALSE(contains_by_reference(square, longer));
  EXPECT_FALSE(farther_than(0, line, square));
  EXPECT_TRUE(farther_than(1.41, longer, square));
  EXPECT_FALSE(farther_than(1.42, longer, square));
  EXPECT_TRUE(farther_than(5.6, line, make_lines({}, {{0, 0}})));
}

}  // namespace
